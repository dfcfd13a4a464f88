// Fixed-point positions (shared/solver_types.h), and the arms between them: exact integer differences,
// in spacings; single precision, or double with PRECISE.
#ifdef PRECISE
#define Arm dvec3
#define Squared double
#else
#define Arm vec3
#define Squared float
#endif

const int kExtraMask = (1 << kExtraBits) - 1;
const float kExtraSteps = float(1 << kExtraBits);

ivec3 extraBits(ivec4 p) {
  return (ivec3(p.w) >> ivec3(0, kExtraBits, 2 * kExtraBits)) & kExtraMask;
}

// In steps of the fixed point, with the extra bits.
vec3 stepsBetween(ivec4 from, ivec4 to) {
  return vec3(to.xyz - from.xyz) + vec3(extraBits(to) - extraBits(from)) / kExtraSteps;
}

Arm armBetween(ivec4 from, ivec4 to, float resolution) {
#ifdef PRECISE
  dvec3 steps = dvec3(to.xyz - from.xyz) +
                dvec3(extraBits(to) - extraBits(from)) * (1.0 / double(kExtraSteps));
  return steps * double(resolution);
#else
  return vec3(to.xyz - from.xyz) * resolution;
#endif
}

// |e| - L from |e|^2; rest = L in steps of restResolution.
float lengthExcess(Squared ee, int rest, float restResolution) {
#ifdef PRECISE
  double restLength = double(rest) * double(restResolution);
  double difference = ee - restLength * restLength;
  return float(difference) / max(sqrt(float(ee)) + float(restLength), 1e-20);  // 0 / 0: no strut
#else
  return sqrt(ee) - float(rest) * restResolution;
#endif
}
