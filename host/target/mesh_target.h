#pragma once
#include "target/target.h"
#include "target/target_request.h"

namespace morphgrid {

/// Loads a mesh, subdivides it, and surveys the part of it that the box of rays meets. Throws
/// InputError when the mesh cannot be read, and, with the box's place and advice, when there is no
/// box or its rays miss or meet an overhang; Cancelled where that is requested.
std::shared_ptr<const Target> loadMeshTarget(const MeshRequest& request,
                                             const Cancellation& cancellation = {});

}  // namespace morphgrid
