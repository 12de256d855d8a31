# Writes what your renderer leaves, for: shadescope compare check_me.toml .
import struct
from array import array


def write_npy(name, shape, numbers):
    """numbers: all of them in a row, the last index of the shape running fastest; row 0 of a picture is its top."""
    header = "{'descr': '<f4', 'fortran_order': False, 'shape': (%s,), }" % ", ".join(map(str, shape))
    header += " " * (63 - (10 + len(header)) % 64) + "\n"
    data = array("f", numbers)
    if struct.pack("=H", 1) != struct.pack("<H", 1):
        data.byteswap()
    with open(name, "wb") as file:
        file.write(b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header.encode() + data.tobytes())


def write_ppm(name, width, height, numbers):
    """numbers: red, green and blue from 0 to 255 of each pixel."""
    with open(name, "wb") as file:
        file.write(b"P6\n%d %d\n255\n" % (width, height) + bytes(numbers))


# What to hand in; leave out what you do not have. V vertices and P polygons are counted over all objects of the scene.
# write_npy("vertices.world.npy", (V, 3), ...)    write_npy("vertices.view.npy", (V, 3), ...)
# write_npy("vertices.screen.npy", (V, 3), ...)   pixels from the top left, pixel centres at .5, and the depth
# write_npy("polygons.visible.npy", (P,), ...)    1 drawn, 0 dropped as a back face
# write_npy("vertices.normal.npy", (V, 3), ...)   write_npy("polygons.normal.npy", (P, 3), ...)
# write_npy("depth.npy", (H, W), ...)             write_npy("polygon_id.npy", (H, W), ...)   -1 where nothing is drawn
# write_npy("normal.npy", (H, W, 3), ...)         write_npy("n_dot_l.0.npy", (H, W), ...)    of light 0
# write_npy("diffuse.0.npy", (H, W, 3), ...)      write_npy("intensity.npy", (H, W, 3), ...)
# write_ppm("color.ppm", W, H, ...)
