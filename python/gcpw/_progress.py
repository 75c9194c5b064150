# This file is part of OpenCV project.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://opencv.org/license.html.
"""How far a long call is."""
from __future__ import annotations

import contextlib
import importlib
import sys
from typing import Any, Callable, Iterator, Optional, Union

#: Called as progress(stage, fraction), fraction 0..1 of the stage; returning False cancels.
Function = Callable[[str, float], Optional[bool]]
#: A function, True for a bar on the terminal, or None.
Progress = Union[Function, bool, None]


def tqdm_or_none() -> Any:
    """tqdm's class, where it is installed."""
    try:
        return importlib.import_module("tqdm").tqdm
    except ImportError:
        return None


class _Bar:
    """A bar for each stage: tqdm's, or one line that is written again and again."""

    def __init__(self) -> None:
        self.tqdm = tqdm_or_none()
        self.bar: Any = None
        self.stage = ""

    def __call__(self, stage: str, fraction: float) -> None:
        if self.tqdm is None:
            sys.stderr.write(f"\r{stage:<12}{100 * fraction:4.0f} %")
            sys.stderr.flush()
            return
        if stage != self.stage or self.bar is None:
            self.close()
            self.stage = stage
            self.bar = self.tqdm(total=100, desc=stage, unit="%", bar_format="{desc:<12}{bar}{percentage:4.0f} % [{elapsed}]")
        self.bar.update(max(0.0, 100 * fraction - self.bar.n))

    def close(self) -> None:
        if self.bar is not None:
            self.bar.close()
            self.bar = None
        elif self.tqdm is None:
            sys.stderr.write("\n")


@contextlib.contextmanager
def shown(progress: Progress) -> Iterator[Optional[Function]]:
    """The function to call for what a caller gave as `progress`."""
    if progress is None or progress is False:
        yield None
    elif progress is True:
        bar = _Bar()
        try:
            yield bar
        finally:
            bar.close()
    elif callable(progress):
        yield progress
    else:
        raise TypeError(f"progress is a function of stage and fraction, True or None, not {type(progress).__name__}")
