/* @FUNCTION@: @RESULT@.
@MEANINGS@
   Complete the function, then:
   gcc -O2 @FILE@ -lm -o mine && shadescope stage @FUNCTION@ pyramid --with ./mine */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

typedef struct { double x, y; } Point;
typedef struct { double x, y, z; } Vector;
typedef struct { int count; double *at; } Numbers;
typedef struct { int count; Point *at; } Points;
typedef struct { int count; Vector *at; } Vectors;

static inline Vector add(Vector a, Vector b) { Vector v = {a.x + b.x, a.y + b.y, a.z + b.z}; return v; }
static inline Vector sub(Vector a, Vector b) { Vector v = {a.x - b.x, a.y - b.y, a.z - b.z}; return v; }
static inline Vector times(double k, Vector a) { Vector v = {k * a.x, k * a.y, k * a.z}; return v; }
static inline double dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static inline double length(Vector a) { return sqrt(dot(a, a)); }
static inline Vector cross(Vector a, Vector b) {
    Vector v = {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    return v;
}
static inline double radians(double degrees) { return degrees * 3.14159265358979323846 / 180; }

static @TYPE@ @FUNCTION@(@PARAMETERS@) {
    @TYPE@ result = {0};
    /* @HINT@ */
    return result;
}

/* Reads the calls and prints the results. Nothing to change from here on. */
static inline double readNumber(void) {
    char word[64] = "";
    if (scanf("%63s", word) != 1) exit(1);
    return strtod(word, NULL);
}
static inline Point readPoint(void) { Point p; p.x = readNumber(); p.y = readNumber(); return p; }
static inline Vector readVector(void) { Vector v; v.x = readNumber(); v.y = readNumber(); v.z = readNumber(); return v; }
#define READ_LIST(List, read) \
    static inline List read##s(void) { \
        List list; \
        list.count = (int)readNumber(); \
        list.at = malloc(sizeof *list.at * (size_t)(list.count + 1)); \
        for (int i = 0; list.at && i < list.count; ++i) list.at[i] = read(); \
        return list; \
    }
READ_LIST(Numbers, readNumber)
READ_LIST(Points, readPoint)
READ_LIST(Vectors, readVector)

static inline void showNumber(double x) { printf("%.17g\n", x); }
static inline void showPoint(Point p) { printf("%.17g %.17g\n", p.x, p.y); }
static inline void showVector(Vector v) { printf("%.17g %.17g %.17g\n", v.x, v.y, v.z); }

int main(void) {
    char name[64];
    int rows, columns;
    if (scanf("%63s %d %d", name, &rows, &columns) != 3) return 1;
    printf("%s %d @COLUMNS@\n", name, rows);
    for (int row = 0; row < rows; ++row) {
@READ@        show@SHOWN@(@FUNCTION@(@ARGUMENTS@));
    }
    return 0;
}
