#pragma once

/// Elementary functions by sums, products and quotients alone: the same bits on every machine,
/// where those of the C library depend on its version and on what the processor can fuse (decision
/// 56). Errors are below 4 units in the last place where nothing else is said, mostly below 1.
namespace gmcr::elementary {

/// |x| up to 1e5.
double sin(double x);
double cos(double x);

/// x in [-1, 1], else NaN.
double asin(double x);

/// Angle of (x, y) in [-pi, pi]; 0 where both are 0.
double atan2(double y, double x);

/// Any x: 0 and infinity where the result is out of range.
double exp(double x);

/// x > 0, infinity too; -infinity at 0, NaN below. Exact for powers of 2, to base 2.
double log(double x);
double log2(double x);
double log10(double x);

/// log(1 + x), x >= -1, exact to rounding for small x too.
double log1p(double x);

/// base > 0, and 0 to a power >= 0. The relative error grows with |exponent log(base)|.
double pow(double base, double exponent);

/// Any x.
double cbrt(double x);

/// log(Gamma(n + 1)), that of n! for whole n; n >= 0, else NaN. The error is below 1e-14 where the
/// value is small.
double log_factorial(double n);

}  // namespace gmcr::elementary
