// SPDX-License-Identifier: BSD-3-Clause
// Student's t: how far a mean may lie from the truth, in standard errors that come from few batches themselves.
#pragma once

namespace uncertainty {

// P(|T| > t) of Student's distribution; a fractional number of degrees of freedom is allowed.
double student_outside(double t, double degrees);

// The t with P(|T| > t) = outside, which lies between 0 and 1.
double student_quantile(double outside, double degrees);

}  // namespace uncertainty
