"""Shadescope from Python: every buffer of a rendering pipeline as a NumPy array.

    import shadescope as sh
    f = sh.render("pyramid", shading="phong")
    f["z_view"]                          # a read-only array, not a copy
    print(f.inspect(268, 281))           # why this pixel has its colour
    g = f.with_({"material.0.n": 4})     # runs only what the change touches
    sh.compare("pyramid", {"depth": mine})
    sh.study("pyramid", shading="all")

Frames never change. A buffer that a frame left out is computed when it is first read, with the same bits.
"""
from __future__ import annotations

import html
import importlib
import io
import json
import os
import threading
from typing import Any, Dict, Iterator, List, Mapping, Optional, Union

import numpy as np

from . import _library as _c
from ._library import Error, Place

__all__ = ["render", "compare", "study", "Frame", "Comparison", "Study", "Pixel", "Error", "Place"]
__version__ = _c.ask(None, "version").decode()

Array = _c.Array
SceneName = Union[str, "os.PathLike[str]"]
Setting = Union[str, bool, int, float]


def _text_of(value: Setting) -> str:
    if isinstance(value, (bool, np.bool_)):
        return "on" if value else "off"
    if isinstance(value, (float, np.floating)):
        return repr(float(value))
    return str(value)


def _assignments(settings: Optional[Mapping[str, Setting]], more: Mapping[str, Setting]) -> bytes:
    both = {**(settings or {}), **more}
    return "; ".join(f"{key}={_text_of(value)}" for key, value in both.items()).encode()


def _scene(scene: SceneName, settings: bytes) -> _c.Handle:
    return _c.call("scene", os.fsencode(scene), settings, _c.poll())


class Frame:
    """One rendered picture with everything that the stages left. It never changes, and threads may share it."""

    def __init__(self, handle: _c.Handle, threads: int = 0):
        self._handle, self._threads = handle, threads
        self._lock = threading.Lock()
        self._arrays: Dict[str, Array] = {}
        self._asked: Dict[str, Any] = {}
        self._compared: Optional[_c.Handle] = None  # the scene, with the reference of comparisons

    # --- buffers
    def __getitem__(self, name: str) -> Array:
        """A buffer as a read-only array over the program's memory: rows from the top, [y, x] or [y, x, channel]."""
        known = self._arrays.get(name)
        if known is not None:
            return known
        with self._lock:
            buffer = _c.lib.shade_buffer(self._handle, name.encode())
            if not buffer:  # left out, or no such buffer: the frame says which
                self._handle = _c.call("frame", self._handle, self._handle, name.encode(), self._threads, _c.poll())
            handle = _c.Handle(buffer) if buffer else _c.call("buffer", self._handle, name.encode())
            return self._arrays.setdefault(name, _c.array(handle))

    def keys(self) -> List[str]:
        """The names of the buffers that this scene has a use for."""
        return [row["name"] for row in self.buffers if not row["useless"]]

    def __iter__(self) -> Iterator[str]:
        return iter(self.keys())

    def __contains__(self, name: object) -> bool:
        return any(row["name"] == name for row in self.buffers)

    def _ask(self, what: str) -> Any:
        if what not in self._asked:
            self._asked[what] = json.loads(_c.ask(self._handle, what))
        return self._asked[what]

    @property
    def buffers(self) -> List[Dict[str, Any]]:
        """Every buffer with its stage, unit and meaning."""
        rows: List[Dict[str, Any]] = self._ask("buffers")
        return rows

    @property
    def settings(self) -> Dict[str, Dict[str, Any]]:
        """Every setting by its key, with value, unit, range and meaning."""
        return {row["key"]: row for row in self._ask("settings")}

    @property
    def plan(self) -> Dict[str, Any]:
        """What each stage ran, reused or left out, why, and in how many milliseconds."""
        plan: Dict[str, Any] = json.loads(_c.ask(self._handle, "plan"))
        return plan

    @property
    def mesh(self) -> Dict[str, Any]:
        """The vertices of every polygon, and the object of each."""
        mesh: Dict[str, Any] = self._ask("mesh")
        return mesh

    # --- other frames
    def with_(self, settings: Optional[Mapping[str, Setting]] = None, **more: Setting) -> "Frame":
        """The frame of the same scene with settings changed. It reuses what the change does not touch."""
        scene = _c.call("with", self._handle, _assignments(settings, more))
        return Frame(_c.call("frame", scene, self._handle, b"", self._threads, _c.poll()), self._threads)

    # --- reading
    def inspect(self, x: int, y: int) -> "Pixel":
        """Everything known about a pixel: column x, row y, from 0 at the top left."""
        place = f"{int(x)},{int(y)}"
        return Pixel(json.loads(_c.ask(self._handle, "inspect", place)), _c.ask(self._handle, "text", place).decode())

    def picture(self, name: str = "color") -> Array:
        """A buffer in the program's colours: [y, x, 3] bytes, for imshow."""
        self[name]
        return _c.array(_c.call("picture", self._handle, name.encode()))

    def png(self, name: str = "color") -> bytes:
        """The same as a PNG file."""
        self[name]
        return _c.ask(self._handle, "png", name)

    def save(self, file: SceneName) -> None:
        """Write the scene as a TOML file, which the window opens."""
        with open(file, "wb") as out:
            out.write(_c.ask(self._handle, "toml"))

    def live(self, height: int = 720) -> Any:
        """The scene as a live page in a notebook's cell: 1.5 MB that work without a server."""
        page = html.escape(_c.ask(self._handle, "live").decode())
        return importlib.import_module("IPython.display").HTML(
            f'<iframe srcdoc="{page}" sandbox="allow-scripts allow-downloads" '
            f'style="width:100%;height:{int(height)}px;border:0"></iframe>')

    def _repr_png_(self) -> bytes:
        return self.png()

    def __repr__(self) -> str:
        s = self.settings
        return f"<shadescope.Frame {s['width']['text']} × {s['height']['text']}, {s['shading']['text']}>"


class _Told(Dict[str, Any]):
    """A dictionary whose text is what the program prints."""

    def __str__(self) -> str:
        return str(self["text"])

    def _repr_pretty_(self, printer: Any, cycle: bool) -> None:
        printer.text(str(self))


class Pixel(_Told):
    """What `shadescope inspect --json` prints; as text the equation with its numbers."""

    def __init__(self, values: Mapping[str, Any], text: str):
        super().__init__(values)
        self.text = text

    def __str__(self) -> str:
        return self.text


def render(scene: SceneName, settings: Optional[Mapping[str, Setting]] = None, *, threads: int = 0,
           **more: Setting) -> Frame:
    """Render a scene file or a built-in scene; settings are those of `--set`: shading="phong", {"light.0.x": 3}."""
    handle = _scene(scene, _assignments(settings, more))
    return Frame(_c.call("frame", handle, None, b"", threads, _c.poll()), threads)


class Comparison(_Told):
    """What `shadescope compare --json` prints. True where all arrays agree."""

    def __bool__(self) -> bool:
        return bool(self["exit"] == 0)


# References of the scenes compared last: the author of a renderer compares again and again.
_references: Dict[Any, _c.Handle] = {}


def _reference(scene: Union[SceneName, Frame], settings: bytes) -> _c.Handle:
    if isinstance(scene, Frame):
        if settings:
            return _c.call("with", scene._handle, settings)
        if scene._compared is None:
            scene._compared = _c.call("with", scene._handle, b"")
        return scene._compared
    name = os.fspath(scene)
    changed = os.stat(name).st_mtime_ns if os.path.exists(name) else 0
    key = (name, changed, settings)
    if key not in _references:
        while len(_references) >= 4:
            _references.pop(next(iter(_references)))
        _references[key] = _scene(scene, settings)
    return _references[key]


def compare(scene: Union[SceneName, Frame], buffers: Mapping[str, Any],
            settings: Optional[Mapping[str, Setting]] = None, *, known: bool = True, **more: Setting) -> Comparison:
    """Name the first wrong stage of another renderer by its buffers: {"depth": array, "color": array}.

    Names, shapes and rules are those of `shadescope compare`. A value may also be the bytes of a file, under a name with
    an ending: {"color.png": data}. known=False: do not look for known errors, which takes some seconds.
    """
    handle = _reference(scene, _assignments(settings, more))
    files = []
    for name, value in buffers.items():
        if isinstance(value, (bytes, bytearray)):
            files.append((name, bytes(value)))
            continue
        out = io.BytesIO()
        np.save(out, np.ascontiguousarray(value), allow_pickle=False)
        files.append((name + ".npy", out.getvalue()))
    return Comparison(json.loads(_c.compare(handle, files, known)))


class Study(_Told):
    """What study.json holds. `rows` has one dictionary for each point: pandas.DataFrame(study.rows) works."""

    @property
    def rows(self) -> List[Dict[str, Any]]:
        rows: List[Dict[str, Any]] = self["rows"]
        return rows


def study(scene: Union[SceneName, Frame], sweeps: Union[str, Mapping[str, Any], None] = None, *, repeat: int = 20,
          **more: Any) -> Study:
    """Error against run time: shading="all", {"camera.rho": [500, 1000]}, or the name of a ready-made sweep.

    It takes its times in this process. For figures of a paper, `shadescope study` takes them in three.
    """
    lines: List[str] = [sweeps] if isinstance(sweeps, str) else []
    for key, values in {**(sweeps if isinstance(sweeps, Mapping) else {}), **more}.items():
        if not isinstance(values, (str, int, float)):
            values = ",".join(_text_of(value) for value in values)
        lines.append(f"{key}={values}")
    handle = scene._handle if isinstance(scene, Frame) else _scene(scene, b"")
    return Study(json.loads(_c.content(_c.call("study", handle, "\n".join(lines).encode(), repeat, _c.poll()))))
