"use strict";
// The viewer of the page: which layer is shown, where the line between both pictures is, how large they are.
// The address keeps it: index.html#layer=mesh&split=30
(function () {
  const viewer = document.querySelector(".viewer");
  if (!viewer) return;
  const stage = viewer.querySelector(".stage");
  const slider = viewer.querySelector("#split");
  const radios = [...viewer.querySelectorAll("input[name=layer]")];
  const buttons = [...viewer.querySelectorAll("[data-zoom]")];
  const overlays = new Set(["lines", "mesh", "cuts"]); // drawn over the picture, not instead of it

  function showLayer(name) {
    for (const part of viewer.querySelectorAll("[data-show]")) {
      const own = part.dataset.show;
      const under = own === "picture" && overlays.has(name) && part.closest(".side");
      part.classList.toggle("on", own === name || Boolean(under));
    }
    for (const radio of radios) radio.checked = radio.value === name;
    viewer.dataset.layer = name;
  }

  function showSplit(percent) {
    if (!slider) return;
    slider.value = percent;
    viewer.style.setProperty("--split", slider.value + "%");
    slider.setAttribute("aria-valuetext", Math.round(slider.value) + " per cent");
  }

  function showZoom(factor) {
    const box = stage.parentElement;
    const middle = (box.scrollLeft + box.clientWidth / 2) / box.scrollWidth;
    const centre = (box.scrollTop + box.clientHeight / 2) / box.scrollHeight;
    viewer.style.setProperty("--zoom", factor);
    box.scrollLeft = middle * box.scrollWidth - box.clientWidth / 2;
    box.scrollTop = centre * box.scrollHeight - box.clientHeight / 2;
    for (const button of buttons) button.setAttribute("aria-pressed", String(button.dataset.zoom === String(factor)));
  }

  function remember() {
    const split = slider ? "&split=" + slider.value : "";
    history.replaceState(null, "", "#layer=" + viewer.dataset.layer + split);
  }

  function recall() {
    const asked = new URLSearchParams(location.hash.slice(1));
    const layer = asked.get("layer");
    showLayer(radios.some((radio) => radio.value === layer) ? layer : "picture");
    const split = parseFloat(asked.get("split"));
    showSplit(Number.isFinite(split) ? split : 50);
  }

  for (const radio of radios)
    radio.addEventListener("change", () => { showLayer(radio.value); remember(); });
  for (const button of buttons)
    button.addEventListener("click", () => showZoom(Number(button.dataset.zoom)));
  if (slider) {
    viewer.classList.add("compared");
    slider.addEventListener("input", () => showSplit(slider.value));
    slider.addEventListener("change", remember);
    const drag = (event) => {
      const box = stage.getBoundingClientRect();
      showSplit(100 * (event.clientX - box.left) / box.width);
    };
    stage.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      stage.setPointerCapture(event.pointerId);
      drag(event);
      slider.focus({ preventScroll: true }); // the arrow keys go on from there
      event.preventDefault();
    });
    stage.addEventListener("pointermove", (event) => { if (stage.hasPointerCapture(event.pointerId)) drag(event); });
    stage.addEventListener("pointerup", remember);
  }
  window.addEventListener("hashchange", recall);
  recall();
})();
