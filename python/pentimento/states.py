"""Reads what `pentimento render` writes: state dumps and layers of pictures."""

import os
from dataclasses import dataclass, field
from typing import Any, Union

import numpy as np
import numpy.typing as npt


@dataclass
class StateDump:
    """A state dump. Rows run from the top of the canvas down; all in SI units."""

    depth_m: npt.NDArray[np.float32]
    velocity_x_m_s: npt.NDArray[np.float32]
    velocity_y_m_s: npt.NDArray[np.float32]  #: y up
    base_m: npt.NDArray[np.float32]
    paper_m: npt.NDArray[np.float32]
    reflectance: npt.NDArray[np.float32]  #: rows, columns, bands
    pigment: npt.NDArray[np.float32]  #: layers, channels, rows, columns; bottom layer first
    stroke: npt.NDArray[np.uint32]
    channels: list[str]
    x_m: npt.NDArray[np.float64]  #: centres of the cells, from the left
    y_m: npt.NDArray[np.float64]  #: from the top
    attributes: dict[str, Any] = field(repr=False)  #: of the file: step, time_s, state_sha256, parameters
    units: dict[str, str] = field(repr=False)  #: of each dataset, by its name in the file

    @property
    def height_m(self) -> npt.NDArray[np.float32]:
        """Of the surface: paper, dried and wet paint."""
        return self.base_m + self.depth_m


def _text(value: Any) -> Any:
    return value.decode() if isinstance(value, bytes) else value


def read_state(file: Union[str, "os.PathLike[str]"]) -> StateDump:
    """Reads a dump (`render -o state.h5`). Needs h5py. Errors: OSError; ValueError for another kind of file."""
    import h5py

    with h5py.File(os.fspath(file), "r") as dump:
        attributes = {name: _text(value) for name, value in dump.attrs.items()}
        if attributes.get("format") != "pentimento-state":
            raise ValueError(f"{os.fspath(file)}: not a state dump")
        units: dict[str, str] = {}
        dump.visititems(lambda name, item: units.update({"/" + name: _text(item.attrs["units"])})
                        if "units" in item.attrs else None)
        depth = dump["/fluid/depth"][...]
        rows, columns = depth.shape
        return StateDump(
            depth_m=depth, velocity_x_m_s=dump["/fluid/velocity_x"][...],
            velocity_y_m_s=dump["/fluid/velocity_y"][...], base_m=dump["/canvas/base"][...],
            paper_m=dump["/canvas/paper"][...], reflectance=dump["/canvas/reflectance"][...],
            pigment=dump["/layers/pigment"][...], stroke=dump["/layers/stroke"][...],
            channels=[_text(name) for name in dump["/layers/channel"][...]],
            x_m=(np.arange(columns) + 0.5) * (float(attributes["canvas_width_m"]) / columns),
            y_m=(np.arange(rows) + 0.5) * (float(attributes["canvas_height_m"]) / rows),
            attributes=attributes, units=units)


@dataclass
class Layer:
    """A layer of a picture (`render --aov`)."""

    values: npt.NDArray[np.float64]  #: rows, columns, or rows, columns, 3
    unit: str


def read_aovs(*files: Union[str, "os.PathLike[str]"]) -> dict[str, Layer]:
    """Reads layers that `render -o out.png --aov depth,...` wrote as PNGs beside the picture, by the names in their
    file names. Needs OpenCV (cv2) and Pillow. Numbers are in the unit that the file says; light is in its sRGB codes, 0..1.
    """
    import cv2
    from PIL import Image

    layers = {}
    for file in files:
        name = os.path.basename(os.fspath(file)).split(".", 1)[1].rsplit(".", 1)[0]
        codes = cv2.imread(os.fspath(file), cv2.IMREAD_UNCHANGED)
        if codes is None:
            raise OSError(f"{os.fspath(file)}: cannot be read as a picture")
        with Image.open(os.fspath(file)) as picture:
            text = dict(getattr(picture, "text", {}))
        values = codes[..., ::-1].astype(float) if codes.ndim == 3 else codes.astype(float)
        if "aov.per_code" in text:
            values = float(text["aov.offset"]) + float(text["aov.per_code"]) * values
        else:
            values /= float(np.iinfo(codes.dtype).max)
        layers[name] = Layer(values, text.get("aov.unit", ""))
    return layers
