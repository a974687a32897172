// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/model/mesh_file.h"

namespace gaitwright {

/// Limits of a mesh: numbers of points, of triangles, and of corners of one face.
inline constexpr std::size_t kMostMeshPoints = 2000000, kMostMeshTriangles = 2000000, kMostFaceCorners = 500;

/// The mesh of the bytes of an STL file. All readers here throw InvalidArgument for invalid data, with the place and
/// the accepted values.
Mesh ParseStl(const std::string& bytes);
/// The mesh of a Wavefront OBJ: `v` and `f` lines; other lines are ignored.
Mesh ParseObj(const std::string& text);
/// The mesh of a Collada file: the geometries of its scene with triangles, polygon lists, strips and fans.
Mesh ParseCollada(const std::string& text);

/// The bytes of a mesh file. Failure as of ReadMesh.
Result<std::string> ReadMeshBytes(const std::string& path);
/// The mesh of the bytes of a file, whose ending tells the format. Failure as of ReadMesh.
Result<Mesh> MeshOfBytes(const std::string& path, const std::string& bytes);

/// Adds a face of three or more corners as triangles, by cutting off ears (Meisters, 1975). The face may be not convex.
/// @param corners  indices into the mesh's vertices. @throws InvalidArgument for fewer than three or too many.
void AddFace(const std::vector<int>& corners, Mesh& mesh);

/// @throws InvalidArgument if a mesh with these numbers of points and triangles is too large.
void CheckMeshSize(std::size_t points, std::size_t triangles);

/// Reads a finite number of a mesh file. @throws InvalidArgument that names `what`.
double MeshNumber(const std::string& word, const std::string& what);

}  // namespace gaitwright
