// Compiles as GLSL and as C++: what the host and the kernels of a frame of welded bars agree on.
// Its vertices are joints, which move and turn. Buffers that hold a texel a vertex for springs hold
// two for a frame, all of the first kind before all of the second: positions, then rotations; in
// vectors, displacements and forces, then turns and moments, both in space.
#ifndef MORPHGRID_FRAME_TYPES_H
#define MORPHGRID_FRAME_TYPES_H
#include "shared/multigrid_types.h"
#ifdef __cplusplus
namespace morphgrid {
#define CONSTANT constexpr
#else
#define CONSTANT const
#endif

// A rotation is a quaternion in fixed point, an ivec4 a joint: x, y, z, w with so many bits behind
// the point. Integers keep what neighbours' rotations differ by to more digits than floats would.
CONSTANT uint kRotationBits = 30u;

// Specialisation constant of the transfers between vertices and columns, bool: the vertices are
// joints.
CONSTANT uint kConstantJointsTurn = 1u;

// Specialisation constant of the kernels that walk a frame's bars, bool: something acts on its
// joints from outside.
CONSTANT uint kConstantIsLoaded = 1u;

// Bindings beside those of solver_types.h and multigrid_types.h. The last two only where joints are
// loaded; what is bound there else is not read.
CONSTANT uint kBindingLoads = 63u;             // texels, vec4 a vertex: force; 1 where it is held
CONSTANT uint kBindingPrintedPositions = 64u;  // texels, ivec4 a vertex, as positions

// How stiff a bar is: lengths in spacings, energies in stiffness x spacing^2.
struct DeviceBarSection {
  float stretching;  // EA
  float bendingN;    // EI where it bends in the sheet's plane as printed; of posts, along x
  float bendingB;    // EI where it bends across
  float twisting;    // GJ
  float shearing;    // 1 / (5/6 GA), 0: it does not shear
};

// What every kernel of a frame gets. Bars rest at grid's rest lengths, less the rigid parts at both
// ends. As printed, lateral bars lie in planes of equal z, along kBindingPrinted's directions, and
// posts stand along z.
struct FramePush {
  GridPush grid;  // Angle weights and stiffnesses are not used.
  DeviceBarSection lateral;
  DeviceBarSection upright;
  float lateralJoint;  // Half the width of the rigid joint at a lateral bar's end; spacings.
  float uprightJoint;
  float holding;       // Stiffness of what holds a joint, against displacements along z,
  float holdingAside;  // along x and y,
  float turning;       // and against turns.
  float damping;       // Stiffness of every bar against any motion, which is added to a Hessian.
  float weight;        // omega, of a step of block-Jacobi smoothing.
  int centreLayer;     // Whose vertices are the columns' centres.
  int firstRow;        // First row of the points dispatched, see point_rows.glsl.
};

#ifdef __cplusplus
static_assert(offsetof(FramePush, lateral) == sizeof(GridPush));
static_assert(offsetof(FramePush, firstRow) == sizeof(GridPush) + 72);
}  // namespace morphgrid
#endif
#undef CONSTANT
#endif
