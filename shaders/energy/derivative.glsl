// What of the energy a kernel adds up. Each term has a function that gives any of them, for one stencil.
#ifndef MORPHGRID_ENERGY_DERIVATIVE
#define MORPHGRID_ENERGY_DERIVATIVE
const int kGradient = 0;             // With the energy itself.
const int kGaussNewtonProduct = 1;   // H z, H positive semidefinite.
const int kExactProduct = 2;         // H z, H the second derivatives, which may be indefinite.
#endif
