#pragma once
// Logarithm and exponential of a Pack with an error of about one ulp; for double those of the standard
// library.

#include "model/numerics/simd.hpp"

namespace femsph {

namespace elementary {

inline constexpr double round_by =
    6755399441055744.0;  ///< 1.5 2^52: adding and subtracting it rounds to an integer

FEMSPH_INLINE Pack from_bits(PackMask bits) { return reinterpret_cast<Pack>(bits); }
FEMSPH_INLINE PackMask to_bits(Pack x) { return reinterpret_cast<PackMask>(x); }

/// u = 2^k m with sqrt(1/2) <= m < sqrt(2); u normal and positive.
FEMSPH_INLINE void split(Pack u, Pack& k, Pack& m) {
  constexpr long root_half = 0x3fe6a09e667f3bcd, one = 0x3ff0000000000000, fraction = 0x000fffffffffffff;
  using Bits = unsigned long __attribute__((vector_size(sizeof(PackMask))));  // that of infinity wraps around
  const PackMask bits = reinterpret_cast<PackMask>(
      reinterpret_cast<Bits>(u) + static_cast<unsigned long>(one - root_half));
  k = from_bits(((bits >> 52) - 1023) + to_bits(broadcast<Pack>(round_by))) - round_by;
  m = from_bits((bits & fraction) + root_half);
}

/// k ln 2 + ln(1 + f) + c, |f| <= sqrt(2) - 1. With s = f/(2 + f): ln(1 + f) = f - s (f - R(s^2)), the
/// polynomial of fdlibm (e_log.c).
FEMSPH_INLINE Pack logarithm(Pack k, Pack f, Pack c) {
  const Pack half_square = 0.5 * f * f, s = f / (2.0 + f), z = s * s, w = z * z;
  const Pack even = w * (3.999999999940941908e-01 +
                         w * (2.222219843214978396e-01 + w * 1.531383769920937332e-01));
  const Pack odd = z * (6.666666666666735130e-01 +
                        w * (2.857142874366239149e-01 +
                             w * (1.818357216161805012e-01 + w * 1.479819860511658591e-01)));
  return s * (half_square + even + odd) + (k * 1.90821492927058770002e-10 + c) - half_square + f +
         k * 6.93147180369123816490e-01;
}

}  // namespace elementary

/// ln x; x = 0 counts as the smallest normal number, x < 0 gives NaN.
FEMSPH_INLINE double natural_log(double x) {
  return std::log(std::isnormal(x) ? x : x == 0 ? 2.2250738585072014e-308 : x);
}
FEMSPH_INLINE Pack natural_log(Pack x) {
  Pack k, m;
  elementary::split(select(x == 0.0, broadcast<Pack>(2.2250738585072014e-308), x), k, m);
  return select(x >= 0.0, elementary::logarithm(k, m - 1.0, Pack{}), broadcast<Pack>(__builtin_nan("")));
}

/// ln(1 + x), accurate for small x; NaN for x <= -1.
FEMSPH_INLINE double log_of_1_plus(double x) { return x > -1 ? std::log1p(x) : __builtin_nan(""); }
FEMSPH_INLINE Pack log_of_1_plus(Pack x) {
  const Pack u = 1.0 + x;
  Pack k, m;
  elementary::split(u, k, m);
  const Pack lost = select(x < 1.0, x - (u - 1.0), 1.0 - (u - x)) / u;  // the rounding error of u
  const auto near = k == 0.0;
  const Pack y = elementary::logarithm(k, select(near, x, m - 1.0), select(near, Pack{}, lost));
  return select(u > 0.0, y, broadcast<Pack>(__builtin_nan("")));
}

/// e^x, with x held between -700 and 700.
FEMSPH_INLINE double exponential(double x) { return std::exp(x < -700 ? -700 : x > 700 ? 700 : x); }
FEMSPH_INLINE Pack exponential(Pack x) {
  x = select(x < -700.0, broadcast<Pack>(-700.0), select(x > 700.0, broadcast<Pack>(700.0), x));
  const Pack shifted = x * 1.44269504088896340736 + elementary::round_by, k = shifted - elementary::round_by;
  const Pack r = (x - k * 6.93147180369123816490e-01) - k * 1.90821492927058770002e-10;  // |r| <= ln(2)/2
  Pack y = broadcast<Pack>(1.0 / 6227020800.0);  // Taylor series to r^13: the error is below 1e-17
  for (const double c : {1.0 / 479001600.0, 1.0 / 39916800.0, 1.0 / 3628800.0, 1.0 / 362880.0, 1.0 / 40320.0,
                         1.0 / 5040.0, 1.0 / 720.0, 1.0 / 120.0, 1.0 / 24.0, 1.0 / 6.0, 0.5, 1.0, 1.0})
    y = y * r + c;
  return y * elementary::from_bits((elementary::to_bits(shifted) -
                                    elementary::to_bits(broadcast<Pack>(elementary::round_by)) + 1023)
                                   << 52);
}

}  // namespace femsph
