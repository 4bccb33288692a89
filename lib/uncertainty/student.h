// SPDX-License-Identifier: BSD-3-Clause
// Student's t: how far a mean may lie from the truth, in standard errors that come from few batches themselves.
#pragma once

namespace uncertainty {

// P(|T| > t) of Student's distribution; a fractional number of degrees of freedom is allowed.
double student_outside(double t, double degrees);

// The t with P(|T| > t) = outside, which lies between 0 and 1.
double student_quantile(double outside, double degrees);

// The normal deviate that is as probable as t, and the t that is as probable as a normal deviate z, to a fiftieth from
// 3 degrees on (D. L. Wallace, Bounds on normal approximations to Student's and the chi-square distributions, Annals of
// Mathematical Statistics 30, 1959): for what asks for many.  degrees: infinite for a normal error.
double normal_of_student(double t, double degrees);
double student_of_normal(double z, double degrees);

}  // namespace uncertainty
