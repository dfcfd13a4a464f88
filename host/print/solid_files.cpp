#include "print/solid_files.h"

#include <Model/COM/NMR_DLLInterfaces.h>
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <bit>
#include <cstdint>
#include <memory>
#include <stdexcept>

namespace morphgrid {
namespace {

using Eigen::Vector3f;

constexpr double kBetweenTiers = 10;  // mm

template <typename Value>
void appendRaw(std::string& bytes, const Value& value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

void appendVector(std::string& bytes, const Vector3f& vector) {
  for (const float value : vector) appendRaw(bytes, value);
}

struct Release {
  void operator()(NMR::PLib3MFBase* object) const { NMR::lib3mf_release(object); }
};
using Handle = std::unique_ptr<NMR::PLib3MFBase, Release>;

void require(LIB3MFRESULT result, const char* what) {
  if (result != LIB3MF_OK) {
    throw std::runtime_error(fmt::format("3MF: lib3mf cannot {}: error {}", what, result));
  }
}

/// The library makes random ones, and the same print should give the same file.
std::string uniqueName(int kind, std::size_t number) {
  return fmt::format("6d6f7270-6867-4{:03x}-8000-{:012x}", kind, number);
}

std::vector<NMR::MODELMESHVERTEX> verticesOf(const SolidMesh& solid) {
  std::vector<NMR::MODELMESHVERTEX> vertices(solid.points.cols());
  for (Eigen::Index n = 0; n < solid.points.cols(); ++n) {
    Eigen::Map<Vector3f>(vertices[n].m_fPosition) = solid.points.col(n).cast<float>();
  }
  return vertices;
}

std::vector<NMR::MODELMESHTRIANGLE> trianglesOf(const SolidMesh& solid) {
  std::vector<NMR::MODELMESHTRIANGLE> triangles(solid.triangles.cols());
  for (Eigen::Index n = 0; n < solid.triangles.cols(); ++n) {
    for (int corner = 0; corner < 3; ++corner) {
      triangles[n].m_nIndices[corner] = static_cast<DWORD>(solid.triangles(corner, n));
    }
  }
  return triangles;
}

void addTier(NMR::PLib3MFModel* model, const SolidMesh& solid, std::size_t number, double x) {
  NMR::PLib3MFModelMeshObject* object = nullptr;
  require(NMR::lib3mf_model_addmeshobject(model, &object), "add an object");
  const Handle keepsObject(object);
  require(NMR::lib3mf_object_setnameutf8(object, fmt::format("tier {}", number).c_str()),
          "name an object");
  require(NMR::lib3mf_object_setuuidutf8(object, uniqueName(1, number).c_str()),
          "identify an object");
  auto vertices = verticesOf(solid);
  auto triangles = trianglesOf(solid);
  require(NMR::lib3mf_meshobject_setgeometry(object, vertices.data(),
                                             static_cast<DWORD>(vertices.size()), triangles.data(),
                                             static_cast<DWORD>(triangles.size())),
          "take a mesh");
  NMR::MODELTRANSFORM transform{};
  for (int axis = 0; axis < 3; ++axis) transform.m_fFields[axis][axis] = 1;
  transform.m_fFields[0][3] = static_cast<float>(x);
  NMR::PLib3MFModelBuildItem* item = nullptr;
  require(NMR::lib3mf_model_addbuilditem(model, object, &transform, &item), "add a build item");
  const Handle keepsItem(item);
  require(NMR::lib3mf_builditem_setuuidutf8(item, uniqueName(2, number).c_str()),
          "identify a build item");
}

std::string packageOf(NMR::PLib3MFModel* model) {
  NMR::PLib3MFModelWriter* writer = nullptr;
  require(NMR::lib3mf_model_querywriter(model, "3mf", &writer), "write");
  const Handle keepsWriter(writer);
  ULONG64 size = 0;
  require(NMR::lib3mf_writer_getstreamsize(writer, &size), "write");
  std::string bytes(size, '\0');
  require(NMR::lib3mf_writer_writetobuffer(writer, reinterpret_cast<BYTE*>(bytes.data()), size),
          "write");
  return bytes;
}

}  // namespace

std::string stlOf(const SolidMesh& solid) {
  static_assert(std::endian::native == std::endian::little);
  std::string bytes = "morphgrid";
  bytes.resize(80, ' ');
  appendRaw(bytes, static_cast<std::uint32_t>(solid.triangles.cols()));
  const Eigen::Matrix3Xf points = solid.points.cast<float>();
  for (const auto& triangle : solid.triangles.colwise()) {
    const Vector3f a = points.col(triangle[0]), b = points.col(triangle[1]),
                   c = points.col(triangle[2]);
    appendVector(bytes, (b - a).cross(c - a).normalized());
    for (const Vector3f& corner : {a, b, c}) appendVector(bytes, corner);
    appendRaw(bytes, std::uint16_t{0});
  }
  return bytes;
}

std::string threeMfOf(const std::vector<SolidMesh>& tiers) {
  NMR::PLib3MFModel* model = nullptr;
  require(NMR::lib3mf_createmodel(&model), "begin a model");
  const Handle keepsModel(model);
  require(NMR::lib3mf_model_setunit(model, NMR::MODELUNIT_MILLIMETER), "set the unit");
  require(NMR::lib3mf_model_setbuilduuidutf8(model, uniqueName(0, 0).c_str()),
          "identify the build");
  double x = 0;
  for (std::size_t n = 0; n < tiers.size(); ++n) {
    addTier(model, tiers[n], n + 1, x);
    x += tiers[n].points.row(0).maxCoeff() - tiers[n].points.row(0).minCoeff() + kBetweenTiers;
  }
  return packageOf(model);
}

}  // namespace morphgrid
