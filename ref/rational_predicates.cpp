#include "ref/rational_predicates.h"

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace cocoon::ref {

namespace {

using Integer = boost::multiprecision::cpp_int;
using Rational = boost::multiprecision::cpp_rational;

template <class Number>
Sign sign_of(const Number& value) {
  return value > 0 ? Sign::positive : value < 0 ? Sign::negative : Sign::zero;
}

// x * 2^1074: every finite double is an integer multiple of 2^-1074. The predicates are
// homogeneous, so a common factor changes no sign.
Integer integer(double x) {
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);
  const Integer mantissa(static_cast<std::int64_t>(std::ldexp(fraction, 53)));
  const int shift = exponent - 53 + 1074;
  return shift >= 0 ? Integer(mantissa << shift) : Integer(mantissa >> -shift);  // drops zeros only
}

// Determinant by expansion along the first row.
template <class Number, std::size_t N>
Number determinant(const std::array<std::array<Number, N>, N>& m) {
  if constexpr (N == 1) {
    return m[0][0];
  } else {
    Number sum = 0;
    for (std::size_t column = 0; column < N; ++column) {
      std::array<std::array<Number, N - 1>, N - 1> minor;
      for (std::size_t i = 1; i < N; ++i)
        for (std::size_t j = 0, k = 0; j < N; ++j)
          if (j != column) minor[i - 1][k++] = m[i][j];
      const Number term = m[0][column] * determinant<Number, N - 1>(minor);
      sum += column % 2 == 0 ? term : Number(-term);
    }
    return sum;
  }
}

std::array<Integer, 3> difference(const Point& p, const Point& q) {
  return {integer(p.x) - integer(q.x), integer(p.y) - integer(q.y), integer(p.z) - integer(q.z)};
}

// The 5 x 5 determinant with rows (x, y, z, x^2 + y^2 + z^2 + raise, 1), of the sign of insphere.
template <class Number>
Number insphere_determinant(const std::array<Point, 5>& p, const std::array<Number, 5>& raise) {
  std::array<std::array<Number, 5>, 5> m;
  for (std::size_t i = 0; i < 5; ++i) {
    const Number x(integer(p[i].x));
    const Number y(integer(p[i].y));
    const Number z(integer(p[i].z));
    m[i] = {x, y, z, Number(x * x + y * y + z * z + raise[i]), Number(1)};
  }
  return -determinant<Number, 5>(m);
}

double rounded(const Rational& value) { return value.convert_to<double>(); }

}  // namespace

Sign orient2d(double ax, double ay, double bx, double by, double cx, double cy) {
  return sign_of(determinant<Integer, 3>({{{integer(ax), integer(ay), 1},
                                           {integer(bx), integer(by), 1},
                                           {integer(cx), integer(cy), 1}}}));
}

Sign orient3d(const Point& a, const Point& b, const Point& c, const Point& d) {
  return sign_of(determinant<Integer, 3>({{difference(b, a), difference(c, a), difference(d, a)}}));
}

Sign insphere(const Point& a, const Point& b, const Point& c, const Point& d, const Point& e) {
  return sign_of(insphere_determinant<Integer>({a, b, c, d, e}, {}));
}

// The center x solves 2 (p - a) . x = |p|^2 - |a|^2 for p = b, c, d. Cramer's rule.
Point circumcenter(const Point& a, const Point& b, const Point& c, const Point& d) {
  std::array<std::array<Rational, 3>, 3> m;
  std::array<Rational, 3> right;
  const auto squared = [](const Point& p) {
    return Rational(Rational(p.x) * Rational(p.x) + Rational(p.y) * Rational(p.y) +
                    Rational(p.z) * Rational(p.z));
  };
  const std::array<Point, 3> others = {b, c, d};
  for (std::size_t i = 0; i < 3; ++i) {
    m[i] = {2 * (Rational(others[i].x) - Rational(a.x)),
            2 * (Rational(others[i].y) - Rational(a.y)),
            2 * (Rational(others[i].z) - Rational(a.z))};
    right[i] = squared(others[i]) - squared(a);
  }
  const Rational denominator = determinant<Rational, 3>(m);
  std::array<double, 3> center;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    auto replaced = m;
    for (std::size_t i = 0; i < 3; ++i) replaced[i][axis] = right[i];
    center[axis] = rounded(Rational(determinant<Rational, 3>(replaced) / denominator));
  }
  return {center[0], center[1], center[2]};
}

Sign insphere_perturbed(const Point& a, const Point& b, const Point& c, const Point& d,
                        const Point& e) {
  const std::array<Point, 5> p = {a, b, c, d, e};
  std::array<std::size_t, 5> order = {0, 1, 2, 3, 4};
  std::sort(order.begin(), order.end(), [&p](std::size_t i, std::size_t j) { return p[i] < p[j]; });
  const auto with_epsilon = [&](const Rational& epsilon) {
    std::array<Rational, 5> raise;
    Rational power = 1;
    for (std::size_t rank = 5; rank-- > 0;) {
      power *= epsilon;
      raise[order[rank]] = power;
    }
    return sign_of(insphere_determinant<Rational>(p, raise));
  };
  // The determinant is a polynomial in epsilon; below its smallest positive root the sign is fixed.
  Rational epsilon = 1;
  Sign previous = Sign::zero;
  for (int same = 0; same < 3;) {
    epsilon /= boost::multiprecision::cpp_int(1) << 200;
    const Sign sign = with_epsilon(epsilon);
    same = sign == previous ? same + 1 : 0;
    previous = sign;
  }
  return previous;
}

}  // namespace cocoon::ref
