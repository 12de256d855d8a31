// @FUNCTION@: @RESULT@.
@MEANINGS@
// Complete the function, then:
//   rustc -O @FILE@ -o mine && shadescope stage @FUNCTION@ pyramid --with ./mine
#![allow(non_snake_case, unused_variables, dead_code)]
use std::io::Read;

type Point = [f64; 2];
type Vector = [f64; 3];

fn add(a: Vector, b: Vector) -> Vector { [a[0] + b[0], a[1] + b[1], a[2] + b[2]] }
fn sub(a: Vector, b: Vector) -> Vector { [a[0] - b[0], a[1] - b[1], a[2] - b[2]] }
fn times(k: f64, a: Vector) -> Vector { [k * a[0], k * a[1], k * a[2]] }
fn dot(a: Vector, b: Vector) -> f64 { a[0] * b[0] + a[1] * b[1] + a[2] * b[2] }
fn length(a: Vector) -> f64 { dot(a, a).sqrt() }
fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn @FUNCTION@(@PARAMETERS@) -> @TYPE@ {
    // @HINT@
    @ZERO@
}

// Reads the calls and prints the results. Nothing to change from here on.
struct Words(Vec<f64>, usize);
impl Words {
    fn readNumber(&mut self) -> f64 { self.1 += 1; self.0[self.1 - 1] }
    fn readPoint(&mut self) -> Point { [self.readNumber(), self.readNumber()] }
    fn readVector(&mut self) -> Vector { [self.readNumber(), self.readNumber(), self.readNumber()] }
    fn readNumbers(&mut self) -> Vec<f64> { let n = self.readNumber() as usize; (0..n).map(|_| self.readNumber()).collect() }
    fn readPoints(&mut self) -> Vec<Point> { let n = self.readNumber() as usize; (0..n).map(|_| self.readPoint()).collect() }
    fn readVectors(&mut self) -> Vec<Vector> { let n = self.readNumber() as usize; (0..n).map(|_| self.readVector()).collect() }
}
trait Show { fn numbers(&self) -> Vec<f64>; }
impl Show for bool { fn numbers(&self) -> Vec<f64> { vec![if *self { 1.0 } else { 0.0 }] } }
impl Show for f64 { fn numbers(&self) -> Vec<f64> { vec![*self] } }
impl<const N: usize> Show for [f64; N] { fn numbers(&self) -> Vec<f64> { self.to_vec() } }

fn main() {
    let mut text = String::new();
    std::io::stdin().read_to_string(&mut text).unwrap();
    let name = text.split_whitespace().next().unwrap();
    let mut words = Words(text.split_whitespace().skip(1).map(|w| w.parse().unwrap()).collect(), 0);
    let rows = words.readNumber() as usize;
    words.readNumber();
    let mut out = format!("{} {} @COLUMNS@\n", name, rows);
    for _ in 0..rows {
@READ@        for x in @FUNCTION@(@ARGUMENTS@).numbers() { out += &format!("{:e} ", x); }
        out += "\n";
    }
    print!("{}", out);
}
