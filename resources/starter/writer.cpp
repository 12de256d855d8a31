// Writes what your renderer leaves, for: shadescope compare check_me.toml .
// Numbers are written as they are in memory, which has to be little-endian, as on all PCs.
#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

// numbers: all of them in a row, the last index of the shape running fastest; row 0 of a picture is its top.
void writeNpy(const std::string& name, const std::vector<std::size_t>& shape, const std::vector<float>& numbers) {
    std::string header = "{'descr': '<f4', 'fortran_order': False, 'shape': (";
    for (std::size_t side : shape) header += std::to_string(side) + ", ";
    header += "), }";
    header += std::string(63 - (10 + header.size()) % 64, ' ') + '\n';
    const auto length = static_cast<std::uint16_t>(header.size());
    std::ofstream file(name, std::ios::binary);
    file.write("\x93NUMPY\x01\x00", 8).write(reinterpret_cast<const char*>(&length), 2);
    file << header;
    file.write(reinterpret_cast<const char*>(numbers.data()), std::streamsize(4 * numbers.size()));
}

// numbers: red, green and blue from 0 to 255 of each pixel.
void writePpm(const std::string& name, int width, int height, const std::vector<std::uint8_t>& numbers) {
    std::ofstream file(name, std::ios::binary);
    file << "P6\n" << width << ' ' << height << "\n255\n";
    file.write(reinterpret_cast<const char*>(numbers.data()), std::streamsize(numbers.size()));
}

// What to hand in; leave out what you do not have. V vertices and P polygons are counted over all objects of the scene.
// writeNpy("vertices.world.npy", {V, 3}, …);    writeNpy("vertices.view.npy", {V, 3}, …);
// writeNpy("vertices.screen.npy", {V, 3}, …);   pixels from the top left, pixel centres at .5, and the depth
// writeNpy("polygons.visible.npy", {P}, …);     1 drawn, 0 dropped as a back face
// writeNpy("vertices.normal.npy", {V, 3}, …);   writeNpy("polygons.normal.npy", {P, 3}, …);
// writeNpy("depth.npy", {H, W}, …);             writeNpy("polygon_id.npy", {H, W}, …);  -1 where nothing is drawn
// writeNpy("normal.npy", {H, W, 3}, …);         writeNpy("n_dot_l.0.npy", {H, W}, …);   of light 0
// writeNpy("diffuse.0.npy", {H, W, 3}, …);      writeNpy("intensity.npy", {H, W, 3}, …);
// writePpm("color.ppm", W, H, …);
