// Writes what your renderer leaves, for: shadescope compare check_me.toml .
import java.io.FileOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;

final class Writer {
    /** numbers: all of them in a row, the last index of the shape running fastest; row 0 of a picture is its top. */
    static void npy(String name, int[] shape, float[] numbers) throws IOException {
        StringBuilder header = new StringBuilder("{'descr': '<f4', 'fortran_order': False, 'shape': (");
        for (int side : shape) header.append(side).append(", ");
        header.append("), }");
        while ((10 + header.length()) % 64 != 63) header.append(' ');
        header.append('\n');
        ByteBuffer bytes = ByteBuffer.allocate(10 + header.length() + 4 * numbers.length).order(ByteOrder.LITTLE_ENDIAN);
        bytes.put((byte) 0x93).put("NUMPY".getBytes(StandardCharsets.US_ASCII)).put((byte) 1).put((byte) 0);
        bytes.putShort((short) header.length()).put(header.toString().getBytes(StandardCharsets.US_ASCII));
        for (float number : numbers) bytes.putFloat(number);
        try (FileOutputStream file = new FileOutputStream(name)) { file.write(bytes.array()); }
    }

    /** numbers: red, green and blue from 0 to 255 of each pixel. */
    static void ppm(String name, int width, int height, byte[] numbers) throws IOException {
        try (FileOutputStream file = new FileOutputStream(name)) {
            file.write(("P6\n" + width + " " + height + "\n255\n").getBytes(StandardCharsets.US_ASCII));
            file.write(numbers);
        }
    }

    // What to hand in; leave out what you do not have. V vertices and P polygons are counted over all objects.
    // npy("vertices.world.npy", {V, 3}, ...)    npy("vertices.screen.npy", {V, 3}, ...)   pixels, and the depth
    // npy("polygons.visible.npy", {P}, ...)     1 drawn, 0 dropped      npy("vertices.normal.npy", {V, 3}, ...)
    // npy("depth.npy", {H, W}, ...)             npy("polygon_id.npy", {H, W}, ...)        -1: nothing drawn
    // npy("normal.npy", {H, W, 3}, ...)         npy("intensity.npy", {H, W, 3}, ...)      ppm("color.ppm", W, H, ...)
}
