// Writes what your renderer leaves, for: shadescope compare check_me.toml .   (Node.js)
const fs = require("fs");

// numbers: all of them in a row, the last index of the shape running fastest; row 0 of a picture is its top.
function writeNpy(name, shape, numbers) {
  let header = `{'descr': '<f4', 'fortran_order': False, 'shape': (${shape.join(", ")},), }`;
  header = header.padEnd(header.length + 63 - ((10 + header.length) % 64)) + "\n";
  const start = Buffer.from([0x93, 0x4e, 0x55, 0x4d, 0x50, 0x59, 1, 0, header.length & 255, header.length >> 8]);
  const data = Buffer.alloc(4 * numbers.length);
  for (let i = 0; i < numbers.length; ++i) data.writeFloatLE(numbers[i], 4 * i);
  fs.writeFileSync(name, Buffer.concat([start, Buffer.from(header, "latin1"), data]));
}

// numbers: red, green and blue from 0 to 255 of each pixel.
function writePpm(name, width, height, numbers) {
  fs.writeFileSync(name, Buffer.concat([Buffer.from(`P6\n${width} ${height}\n255\n`), Buffer.from(numbers)]));
}

module.exports = { writeNpy, writePpm };
// What to hand in; leave out what you do not have. V vertices and P polygons are counted over all objects of the scene.
// writeNpy("vertices.world.npy", [V, 3], ...)    writeNpy("vertices.view.npy", [V, 3], ...)
// writeNpy("vertices.screen.npy", [V, 3], ...)   pixels from the top left, pixel centres at .5, and the depth
// writeNpy("polygons.visible.npy", [P], ...)     1 drawn, 0 dropped as a back face
// writeNpy("vertices.normal.npy", [V, 3], ...)   writeNpy("polygons.normal.npy", [P, 3], ...)
// writeNpy("depth.npy", [H, W], ...)             writeNpy("polygon_id.npy", [H, W], ...)   -1 where nothing is drawn
// writeNpy("normal.npy", [H, W, 3], ...)         writeNpy("n_dot_l.0.npy", [H, W], ...)    of light 0
// writeNpy("diffuse.0.npy", [H, W, 3], ...)      writeNpy("intensity.npy", [H, W, 3], ...)
// writePpm("color.ppm", W, H, ...)
