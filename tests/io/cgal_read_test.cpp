// CGAL's readers, where they know the format, see the same vertices and faces.
#include "ref/cgal_read.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <string>

#include "io/mesh_file.h"
#include "tests/temporary_folder.h"

namespace cocoon {
namespace {

const std::filesystem::path folder = std::filesystem::path(COCOON_TEST_DATA) / "io";

TEST(CgalRead, SeesTheSameTriangleMeshes) {
  for (const char* name :
       {"ply/assimp__cube_binary.ply", "ply/tinyply__icosahedron.ply", "ply/trimesh__mirror.ply",
        "ply/trimesh__reference.ply", "nasty/ply_be_double_uint.ply", "nasty/off_coff.off",
        "nasty/off_noff.off", "obj/trimesh__cube_compressed.obj",
        "obj/trimesh__joined_tetrahedra.obj", "stl/trimesh__unit_cube.STL",
        "stl/assimp__3DSMaxExport.STL", "stl/trimesh__multibody.stl"}) {
    TriangleMesh mesh = read_mesh(folder / name);
    TriangleMesh cgal = ref::cgal_read_mesh(folder / name);
    EXPECT_EQ(mesh.points, cgal.points) << name;
    canonicalize_triangles(mesh);
    canonicalize_triangles(cgal);
    EXPECT_EQ(mesh.triangles, cgal.triangles) << name;
    EXPECT_GT(mesh.triangles.size(), 0U) << name;
  }
}

TEST(CgalRead, ReadsWhatIsWritten) {
  const TemporaryFolder temporary;
  const TriangleMesh mesh = read_mesh(folder / "ply/happly__platonic_shelf.ply");
  for (const char* name : {"a.ply", "a.off", "a.obj"}) {
    for (bool ascii : {false, true}) {
      write_mesh(temporary / name, mesh, {.ascii = ascii});
      EXPECT_EQ(ref::cgal_read_mesh(temporary / name), mesh) << name;
    }
  }
}

}  // namespace
}  // namespace cocoon
