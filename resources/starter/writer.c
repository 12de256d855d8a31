/* Writes what your renderer leaves, for: shadescope compare check_me.toml .
   Numbers are written as they are in memory, which has to be little-endian, as on all PCs. */
#include <stdint.h>
#include <stdio.h>

/* numbers: rows * columns * channels floats; row 0 of a picture is its top. columns or channels 0: one index less. */
int write_npy(const char* name, int rows, int columns, int channels, const float* numbers) {
    char header[118], shape[64];
    uint16_t length = sizeof header;
    size_t count = (size_t)rows * (columns ? columns : 1) * (channels ? channels : 1);
    FILE* file = fopen(name, "wb");
    if (!file) return 0;
    if (!columns) snprintf(shape, sizeof shape, "%d,", rows);
    else if (!channels) snprintf(shape, sizeof shape, "%d, %d", rows, columns);
    else snprintf(shape, sizeof shape, "%d, %d, %d", rows, columns, channels);
    int used = snprintf(header, sizeof header, "{'descr': '<f4', 'fortran_order': False, 'shape': (%s), }", shape);
    for (; used < (int)sizeof header - 1; ++used) header[used] = ' ';
    header[sizeof header - 1] = '\n';
    fwrite("\x93NUMPY\x01\x00", 1, 8, file);
    fwrite(&length, 2, 1, file);
    fwrite(header, 1, sizeof header, file);
    fwrite(numbers, sizeof(float), count, file);
    return fclose(file) == 0;
}

/* numbers: red, green and blue from 0 to 255 of each pixel. */
int write_ppm(const char* name, int width, int height, const unsigned char* numbers) {
    FILE* file = fopen(name, "wb");
    if (!file) return 0;
    fprintf(file, "P6\n%d %d\n255\n", width, height);
    fwrite(numbers, 3, (size_t)width * height, file);
    return fclose(file) == 0;
}

/* What to hand in; leave out what you do not have. V vertices and P polygons are counted over all objects.
   write_npy("vertices.world.npy", V, 3, 0, ...)   write_npy("vertices.screen.npy", V, 3, 0, ...)  pixels, and the depth
   write_npy("polygons.visible.npy", P, 0, 0, ...) 1 drawn, 0 dropped     write_npy("vertices.normal.npy", V, 3, 0, ...)
   write_npy("depth.npy", H, W, 0, ...)            write_npy("polygon_id.npy", H, W, 0, ...)       -1: nothing drawn
   write_npy("normal.npy", H, W, 3, ...)           write_npy("intensity.npy", H, W, 3, ...)        write_ppm("color.ppm", W, H, ...) */
