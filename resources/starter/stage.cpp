// @FUNCTION@: @RESULT@.
@MEANINGS @
// Complete the function, then:
//   g++ -std=c++17 -O2 @FILE@ -o mine && shadescope stage @FUNCTION@ pyramid --with ./mine
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

    using Point = std::array<double, 2>;
using Vector = std::array<double, 3>;

inline Vector operator+(Vector a, Vector b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Vector operator-(Vector a, Vector b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Vector operator*(double k, Vector a) { return {k * a[0], k * a[1], k * a[2]}; }
inline double dot(Vector a, Vector b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline double length(Vector a) { return std::sqrt(dot(a, a)); }
inline Vector cross(Vector a, Vector b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double radians(double degrees) { return degrees * 3.14159265358979323846 / 180; }

@TYPE @ @FUNCTION @(@PARAMETERS @) {
    // @HINT@
    return {};
}

// Reads the calls and prints the results. Nothing to change from here on.
double readNumber() {
    std::string word;
    std::cin >> word;
    return std::strtod(word.c_str(), nullptr);
}
Point readPoint() { return {readNumber(), readNumber()}; }
Vector readVector() { return {readNumber(), readNumber(), readNumber()}; }
template <class Read>
auto readList(Read read) {
    std::vector<decltype(read())> list(static_cast<std::size_t>(readNumber()));
    for (auto& one : list) one = read();
    return list;
}
std::vector<double> readNumbers() { return readList(readNumber); }
std::vector<Point> readPoints() { return readList(readPoint); }
std::vector<Vector> readVectors() { return readList(readVector); }

void show(double x) { std::printf("%.17g\n", x); }
template <std::size_t N>
void show(const std::array<double, N>& result) {
    for (double x : result) std::printf("%.17g ", x);
    std::puts("");
}

int main() {
    std::string name;
    int rows, columns;
    std::cin >> name >> rows >> columns;
    std::printf("%s %d @COLUMNS@\n", name.c_str(), rows);
    for (int row = 0; row < rows; ++row) {
        @READ @show(@FUNCTION @(@ARGUMENTS @));
    }
}
