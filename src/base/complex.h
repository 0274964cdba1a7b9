// SPDX-License-Identifier: GPL-3.0-or-later
// Complex numbers whose operations give the same bits everywhere, unlike those of std::complex,
// which also would check every product for infinities. Used by fractals
// and Fourier transforms.
#pragma once

namespace candelabra {

struct Complex {
    double re = 0, im = 0;

    double squared_size() const { return re * re + im * im; }
    friend bool operator==(const Complex&, const Complex&) = default;
};

inline Complex operator+(Complex u, Complex v) { return {u.re + v.re, u.im + v.im}; }
inline Complex operator+(Complex u, double v) { return {u.re + v, u.im}; }
inline Complex operator-(Complex u, Complex v) { return {u.re - v.re, u.im - v.im}; }
inline Complex operator*(Complex u, Complex v) {
    return {u.re * v.re - u.im * v.im, u.re * v.im + u.im * v.re};
}
inline Complex operator*(double s, Complex v) { return {s * v.re, s * v.im}; }
inline Complex operator/(Complex u, Complex v) {
    const double size = v.squared_size();
    return {(u.re * v.re + u.im * v.im) / size, (u.im * v.re - u.re * v.im) / size};
}
inline Complex conjugate(Complex z) { return {z.re, -z.im}; }
/// z times the imaginary unit.
inline Complex turned(Complex z) { return {-z.im, z.re}; }

// Principal values: cuts are along the negative real axis, and the sign of a zero chooses the side.

Complex exp(Complex);
Complex log(Complex);
Complex sqrt(Complex);
Complex sin(Complex);
Complex cos(Complex);
Complex tan(Complex);
Complex sinh(Complex);
Complex cosh(Complex);
Complex tanh(Complex);

}  // namespace candelabra
