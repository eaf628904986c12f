#include "ref/rational_predicates.h"

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cstddef>

namespace cocoon::ref {

namespace {

using Rational = boost::multiprecision::cpp_rational;

Sign sign_of(const Rational& value) {
  return value > 0 ? Sign::positive : value < 0 ? Sign::negative : Sign::zero;
}

// Determinant by expansion along the first row.
template <std::size_t N>
Rational determinant(const std::array<std::array<Rational, N>, N>& m) {
  if constexpr (N == 1) {
    return m[0][0];
  } else {
    Rational sum = 0;
    for (std::size_t column = 0; column < N; ++column) {
      std::array<std::array<Rational, N - 1>, N - 1> minor;
      for (std::size_t i = 1; i < N; ++i)
        for (std::size_t j = 0, k = 0; j < N; ++j)
          if (j != column) minor[i - 1][k++] = m[i][j];
      const Rational term = m[0][column] * determinant<N - 1>(minor);
      sum += column % 2 == 0 ? term : Rational(-term);
    }
    return sum;
  }
}

std::array<Rational, 3> difference(const Point& p, const Point& q) {
  return {Rational(p.x) - Rational(q.x), Rational(p.y) - Rational(q.y),
          Rational(p.z) - Rational(q.z)};
}

// The 5 x 5 determinant with rows (x, y, z, x^2 + y^2 + z^2 + raise, 1), of the sign of insphere.
Rational insphere_determinant(const std::array<Point, 5>& p, const std::array<Rational, 5>& raise) {
  std::array<std::array<Rational, 5>, 5> m;
  for (std::size_t i = 0; i < 5; ++i) {
    const Rational x(p[i].x);
    const Rational y(p[i].y);
    const Rational z(p[i].z);
    m[i] = {x, y, z, Rational(x * x + y * y + z * z + raise[i]), Rational(1)};
  }
  return -determinant<5>(m);
}

}  // namespace

Sign orient2d(double ax, double ay, double bx, double by, double cx, double cy) {
  const std::array<std::array<Rational, 3>, 3> m = {{{Rational(ax), Rational(ay), Rational(1)},
                                                     {Rational(bx), Rational(by), Rational(1)},
                                                     {Rational(cx), Rational(cy), Rational(1)}}};
  return sign_of(determinant<3>(m));
}

Sign orient3d(const Point& a, const Point& b, const Point& c, const Point& d) {
  const std::array<std::array<Rational, 3>, 3> m = {
      {difference(b, a), difference(c, a), difference(d, a)}};
  return sign_of(determinant<3>(m));
}

Sign insphere(const Point& a, const Point& b, const Point& c, const Point& d, const Point& e) {
  return sign_of(insphere_determinant({a, b, c, d, e}, {}));
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
    return sign_of(insphere_determinant(p, raise));
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
