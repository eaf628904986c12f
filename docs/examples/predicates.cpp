// Signs that floating point gets wrong, and ties that have to be broken.
#include <cstdio>

#include "geom/insphere.h"
#include "geom/orient3d.h"
#include "geom/perturbation.h"

int main() {
  using cocoon::Point;
  using cocoon::Sign;

  // Four points beside one plane: the first one by 2^-50. In doubles it vanishes when the
  // differences of coordinates are rounded, and the determinant is zero.
  const Point a{0.5, 0.5 + 0x1p-50, 0};
  const Point b{12, 12, 0};
  const Point c{0, 0, 1};
  const Point d{24, 24, 0};
  const cocoon::FilteredDeterminant filter = cocoon::orient3d_filter(a, b, c, d);
  const Sign side = cocoon::orient3d(a, b, c, d);
  std::printf("determinant %g, error up to %g; exact sign %d\n", filter.value, filter.error,
              static_cast<int>(side));

  // Five corners of a cube lie on one sphere. The tie is broken by their coordinates alone, as if
  // each were lifted by an infinitesimal that grows with its lexicographic rank: whoever asks, in
  // whatever order, hears the same.
  const Point p{0, 0, 0};
  const Point q{1, 0, 0};
  const Point r{0, 1, 0};
  const Point s{0, 0, 1};
  const Point t{1, 1, 1};
  const Sign exact = cocoon::insphere(p, q, r, s, t);
  const Sign broken = cocoon::insphere_perturbed(p, q, r, s, t);
  std::printf("insphere %d, perturbed %d\n", static_cast<int>(exact), static_cast<int>(broken));
  const bool as_expected =
      filter.value == 0 && side == Sign::negative && exact == Sign::zero && broken != Sign::zero;
  return as_expected ? 0 : 1;
}
