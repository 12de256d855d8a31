// @FUNCTION@: @RESULT@.
@MEANINGS@
// Complete the function, then: shadescope stage @FUNCTION@ pyramid --with "java @FILE@"
import java.io.BufferedInputStream;
import java.util.Locale;
import java.util.Scanner;

class Stage {
    static double[] add(double[] a, double[] b) { return new double[] {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
    static double[] sub(double[] a, double[] b) { return new double[] {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
    static double[] times(double k, double[] a) { return new double[] {k * a[0], k * a[1], k * a[2]}; }
    static double dot(double[] a, double[] b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
    static double length(double[] a) { return Math.sqrt(dot(a, a)); }
    static double[] cross(double[] a, double[] b) {
        return new double[] {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    }

    static @TYPE@ @FUNCTION@(@PARAMETERS@) {
        // @HINT@
        return @ZERO@;
    }

    // Reads the calls and prints the results. Nothing to change from here on.
    static final Scanner words = new Scanner(new BufferedInputStream(System.in)).useLocale(Locale.ROOT);
    static final StringBuilder out = new StringBuilder();

    static double readNumber() { return Double.parseDouble(words.next()); }
    static double[] readMany(int count) {
        double[] numbers = new double[count];
        for (int i = 0; i < count; ++i) numbers[i] = readNumber();
        return numbers;
    }
    static double[][] readList(int size) {
        double[][] list = new double[(int) readNumber()][];
        for (int i = 0; i < list.length; ++i) list[i] = readMany(size);
        return list;
    }
    static double[] readPoint() { return readMany(2); }
    static double[] readVector() { return readMany(3); }
    static double[] readNumbers() { return readMany((int) readNumber()); }
    static double[][] readPoints() { return readList(2); }
    static double[][] readVectors() { return readList(3); }

    static void show(boolean truth) { out.append(truth ? "1\n" : "0\n"); }
    static void show(double... result) {
        for (double x : result) out.append(x).append(' ');
        out.append('\n');
    }

    public static void main(String[] unused) {
        String name = words.next();
        int rows = words.nextInt();
        words.nextInt();
        out.append(name + " " + rows + " @COLUMNS@\n");
        for (int row = 0; row < rows; ++row) {
@READ@            show(@FUNCTION@(@ARGUMENTS@));
        }
        System.out.print(out);
    }
}
