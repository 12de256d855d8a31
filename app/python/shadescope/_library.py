"""The C calls of libshadescope, by ctypes."""
from __future__ import annotations

import ctypes
import json
import os
import threading
from typing import TYPE_CHECKING, Any, Iterator, List, NamedTuple, Sequence, Tuple, cast

import numpy as np

if TYPE_CHECKING:
    Array = np.ndarray[Any, Any]
else:
    Array = np.ndarray


class Place(NamedTuple):
    """What is wrong, and where: file, line and column as an editor counts them, 0 where they are not known."""
    file: str
    line: int
    column: int
    found: str
    expected: str
    keys: Tuple[str, ...]


class Error(ValueError):
    """Something in the given data is wrong. The text has one line an error, FILE:LINE:COLUMN: found, expected."""

    def __init__(self, text: str, places: Sequence[Place] = ()):
        super().__init__(text)
        self.places: List[Place] = list(places)


class View(ctypes.Structure):
    _fields_ = [("data", ctypes.c_void_p), ("dtype", ctypes.c_char_p), ("shape", ctypes.c_size_t * 4),
                ("dimensions", ctypes.c_int)]


class File(ctypes.Structure):
    _fields_ = [("name", ctypes.c_char_p), ("bytes", ctypes.c_char_p), ("size", ctypes.c_size_t)]


_Poll = ctypes.CFUNCTYPE(ctypes.c_int)
_here = os.path.dirname(os.path.abspath(__file__))
lib = ctypes.CDLL(os.path.join(_here, "libshadescope.so"))
_h, _s, _i = ctypes.c_void_p, ctypes.c_char_p, ctypes.c_int
for _name, _result, _arguments in (
        ("resources", None, [_s]), ("scene", _h, [_s, _s, _Poll]), ("with", _h, [_h, _s]),
        ("frame", _h, [_h, _h, _s, _i, _Poll]), ("buffer", _h, [_h, _s]), ("picture", _h, [_h, _s]),
        ("ask", _h, [_h, _s, _s, _Poll]), ("compare", _h, [_h, ctypes.POINTER(File), _i, _i, _Poll]),
        ("study", _h, [_h, _s, _i, _Poll]), ("view", _i, [_h, ctypes.POINTER(View)]), ("error", _s, []),
        ("free", None, [_h])):
    _function = getattr(lib, "shade_" + _name)
    _function.restype, _function.argtypes = _result, _arguments
_share = os.path.join(_here, "share")
if os.path.isdir(_share):  # an installed package has scenes and the parts of live pages beside it
    lib.shade_resources(os.fsencode(_share))

_interrupted: List[BaseException] = []


def _asks() -> Iterator[int]:
    # Python handles signals, as Ctrl+C, while the main thread runs Python: in here, as soon as a long call asks. A function
    # would be interrupted before its first line, outside any try; a generator goes on within it.
    while True:
        try:
            while True:
                yield 0
        except GeneratorExit:  # Python ends
            return
        except BaseException as error:  # KeyboardInterrupt, or what the user's own handler raises
            _interrupted.append(error.with_traceback(None))  # whoever clears its frames would end this generator
            yield 1


_asking = _asks()
next(_asking)
_asked, _never = _Poll(cast(Any, _asking.__next__)), _Poll(0)


def poll() -> Any:
    """Signals reach the main thread alone: calls on other threads are not asked whether to stop."""
    return _asked if threading.current_thread() is threading.main_thread() else _never


class Handle:
    """Frees a handle of the library with its last owner; passes as the pointer itself."""
    __slots__ = ("_as_parameter_", "__weakref__")

    def __init__(self, pointer: int):
        self._as_parameter_ = pointer

    def __del__(self, free: Any = lib.shade_free) -> None:
        free(self._as_parameter_)


def _raise() -> None:
    told = json.loads(lib.shade_error())
    if "memory" in told:
        raise MemoryError("Shadescope: not enough memory; a smaller picture and fewer buffers need less")
    if "stopped" in told:
        raise _interrupted.pop() if _interrupted else KeyboardInterrupt()
    errors = told["errors"]
    raise Error("\n".join(row["text"] for row in errors),
                [Place(row.get("file", ""), row.get("line", 0), row.get("column", 0), row["found"],
                       row.get("expected", ""), tuple(row.get("keys", ()))) for row in errors])


def call(name: str, *arguments: Any) -> Handle:
    pointer = getattr(lib, "shade_" + name)(*arguments)
    if not pointer:
        _raise()
    return Handle(pointer)


def content(handle: Handle) -> bytes:
    """The bytes of a text."""
    view = View()
    lib.shade_view(handle, view)
    return ctypes.string_at(view.data, view.shape[0])


def ask(handle: Any, what: str, argument: str = "") -> bytes:
    return content(call("ask", handle, what.encode(), argument.encode(), poll()))


class _Memory:
    """What NumPy reads. It holds the buffer for as long as an array looks at it."""

    def __init__(self, handle: Handle):
        view = View()
        lib.shade_view(handle, view)
        self.handle = handle
        self.__array_interface__ = {"data": (view.data or 0, True), "typestr": np.dtype(view.dtype.decode()).str,
                                    "shape": tuple(view.shape[:view.dimensions]), "version": 3}


def array(handle: Handle) -> Array:
    """A buffer or a picture as a read-only array, without a copy."""
    return np.asarray(_Memory(handle))


def compare(scene: Handle, files: Sequence[Tuple[str, bytes]], known: bool) -> bytes:
    rows = (File * len(files))(*[File(name.encode(), data, len(data)) for name, data in files])
    return content(call("compare", scene, rows, len(files), known, poll()))
