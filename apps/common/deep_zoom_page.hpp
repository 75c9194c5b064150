// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html.
#ifndef GCPW_APPS_DEEP_ZOOM_PAGE_HPP
#define GCPW_APPS_DEEP_ZOOM_PAGE_HPP

/** The page that shows a Deep Zoom picture without a network. @...@ stand for its title, size and tiles.

Drawn on one canvas: the coarser levels below, so that something is seen while finer tiles load. */
const char* const DEEP_ZOOM_PAGE = R"page(<!DOCTYPE html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>@TITLE@</title>
<style>
  html, body { margin: 0; height: 100%; background: #222; overflow: hidden; }
  canvas { display: block; width: 100%; height: 100%; cursor: grab; touch-action: none; }
</style>
<canvas tabindex="0" aria-label="@TITLE@: drag to move, wheel, + and - to zoom, 0 shows all"></canvas>
<script>
"use strict";
const W = @WIDTH@, H = @HEIGHT@, TILE = @TILE@, OVERLAP = @OVERLAP@, FOLDER = "@TILES@";
const TOP = Math.ceil(Math.log2(Math.max(W, H)));
const KEPT = 400;                     // tiles in memory
const canvas = document.querySelector("canvas"), pen = canvas.getContext("2d");
const tiles = new Map();              // "level/column_row" -> Image, the latest used last
const fingers = new Map();
let x = W / 2, y = H / 2, zoom = 0, asked = false;   // the middle, and screen pixels a pixel

const least = () => Math.min(canvas.width / W, canvas.height / H);
function tile(level, column, row) {
  const key = level + "/" + column + "_" + row;
  let image = tiles.get(key);
  if (!image) {
    image = new Image();
    image.onload = ask;
    image.src = FOLDER + "/" + key + ".jpg";
  }
  tiles.delete(key);
  tiles.set(key, image);
  return image;
}
function drawLevel(level) {
  const size = 2 ** (TOP - level), step = TILE * size;
  const left = x - canvas.width / 2 / zoom, top = y - canvas.height / 2 / zoom;
  const columns = Math.ceil(Math.ceil(W / size) / TILE), rows = Math.ceil(Math.ceil(H / size) / TILE);
  for (let row = Math.max(0, Math.floor(top / step)); row < rows && row * step < top + canvas.height / zoom; ++row)
    for (let column = Math.max(0, Math.floor(left / step)); column < columns && column * step < left + canvas.width / zoom; ++column) {
      const image = tile(level, column, row);
      if (!image.complete || !image.naturalWidth) continue;
      const from = column ? OVERLAP : 0, above = row ? OVERLAP : 0;
      pen.drawImage(image, (column * step - from * size - left) * zoom, (row * step - above * size - top) * zoom,
                    image.naturalWidth * size * zoom, image.naturalHeight * size * zoom);
    }
}
function draw() {
  asked = false;
  const most = Math.max(4, least());
  zoom = Math.min(Math.max(zoom, least()), most);
  x = Math.min(Math.max(x, 0), W);
  y = Math.min(Math.max(y, 0), H);
  pen.clearRect(0, 0, canvas.width, canvas.height);
  const finest = Math.min(TOP, Math.max(0, TOP + Math.ceil(Math.log2(zoom))));
  for (let level = Math.min(finest, 8); level < finest; level += 2) drawLevel(level);
  drawLevel(finest);
  for (const key of tiles.keys()) if (tiles.size > KEPT) tiles.delete(key); else break;
}
function ask() { if (!asked) { asked = true; requestAnimationFrame(draw); } }
function zoomAt(factor, cx, cy) {     // the point below (cx, cy) stays where it is
  const before = zoom;
  zoom = Math.min(Math.max(zoom * factor, least()), Math.max(4, least()));
  x += (cx - canvas.width / 2) * (1 / before - 1 / zoom);
  y += (cy - canvas.height / 2) * (1 / before - 1 / zoom);
  ask();
}
const at = event => [event.clientX * devicePixelRatio, event.clientY * devicePixelRatio];
const spread = () => { const [a, b] = fingers.values(); return Math.hypot(a[0] - b[0], a[1] - b[1]); };
function resized() {
  canvas.width = canvas.clientWidth * devicePixelRatio;
  canvas.height = canvas.clientHeight * devicePixelRatio;
  ask();
}
canvas.onpointerdown = event => { canvas.setPointerCapture(event.pointerId); fingers.set(event.pointerId, at(event)); };
canvas.onpointerup = canvas.onpointercancel = event => fingers.delete(event.pointerId);
canvas.onpointermove = event => {
  const before = fingers.get(event.pointerId), now = at(event);
  if (!before) return;
  const apart = fingers.size === 2 ? spread() : 0;
  fingers.set(event.pointerId, now);
  x -= (now[0] - before[0]) / zoom / fingers.size;
  y -= (now[1] - before[1]) / zoom / fingers.size;
  if (apart) zoomAt(spread() / apart, now[0], now[1]);
  ask();
};
canvas.addEventListener("wheel", event => { event.preventDefault(); zoomAt(Math.exp(-event.deltaY / 400), ...at(event)); }, {passive: false});
addEventListener("keydown", event => {
  const step = 100 / zoom, middle = [canvas.width / 2, canvas.height / 2];
  if (event.key === "+") zoomAt(1.5, ...middle);
  if (event.key === "-") zoomAt(1 / 1.5, ...middle);
  if (event.key === "0") { zoom = 0; x = W / 2; y = H / 2; }
  if (event.key === "ArrowLeft") x -= step;
  if (event.key === "ArrowRight") x += step;
  if (event.key === "ArrowUp") y -= step;
  if (event.key === "ArrowDown") y += step;
  ask();
});
addEventListener("resize", resized);
resized();
</script>
</html>
)page";

#endif
