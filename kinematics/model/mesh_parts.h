// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/model/mesh_file.h"

namespace gaitwright {

/// Bounds of a mesh: number of points, of triangles, of corners of one face.
inline constexpr std::size_t kMostMeshPoints = 2000000, kMostMeshTriangles = 2000000, kMostFaceCorners = 500;

/// The mesh of an STL file's bytes. @throws InvalidArgument for invalid data, with the place and what is accepted.
Mesh ParseStl(const std::string& bytes);
/// The mesh of a Wavefront OBJ: `v` and `f` lines; other lines are ignored.
Mesh ParseObj(const std::string& text);
/// The mesh of a Collada file: the geometries of its scene with triangles, polygon lists, strips and fans.
Mesh ParseCollada(const std::string& text);

/// The bytes of a mesh file. Failure as of ReadMesh.
Result<std::string> ReadMeshBytes(const std::string& path);
/// The mesh of the bytes of a file, whose ending tells the format. Failure as of ReadMesh.
Result<Mesh> MeshOfBytes(const std::string& path, const std::string& bytes);

/// Adds a face of three corners or more as triangles, by cutting off ears where it is not convex (Meisters, 1975).
/// @param corners  indices into the mesh's vertices. @throws InvalidArgument for fewer than three or too many.
void AddFace(const std::vector<int>& corners, Mesh& mesh);

/// @throws InvalidArgument when a mesh of so many points and triangles is too large.
void CheckMeshSize(std::size_t points, std::size_t triangles);

/// A finite number of a mesh's file. @throws InvalidArgument naming `what`.
double MeshNumber(const std::string& word, const std::string& what);

}  // namespace gaitwright
