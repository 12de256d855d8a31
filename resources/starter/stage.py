# @FUNCTION@: @RESULT@.
@MEANINGS@
# Complete the function, then: shadescope stage @FUNCTION@ pyramid --with "python3 @FILE@"
import sys
from math import cos, floor, radians, sin, sqrt


def add(a, b): return [x + y for x, y in zip(a, b)]
def sub(a, b): return [x - y for x, y in zip(a, b)]
def times(k, a): return [k * x for x in a]
def dot(a, b): return sum(x * y for x, y in zip(a, b))
def length(a): return sqrt(dot(a, a))
def cross(a, b): return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def @FUNCTION@(@PARAMETERS@):
    # @HINT@
    return @ZERO@


# Reads the calls and prints the results. Nothing to change from here on.
words = iter(sys.stdin.read().split())


def one(kind):
    size = {"Number": 1, "Point": 2, "Vector": 3}[kind]
    numbers = [float(next(words)) for _ in range(size)]
    return numbers[0] if size == 1 else numbers


def value(kind):
    if kind[-1] != "s":
        return one(kind)
    return [one(kind[:-1]) for _ in range(int(next(words)))]


name, rows, columns = next(words), int(next(words)), next(words)
print(name, rows, @COLUMNS@)
for row in range(rows):
    result = @FUNCTION@(*[value(kind) for kind in [@KINDS@]])
    print(*(repr(float(x)) for x in (result if isinstance(result, (list, tuple)) else [result])))
