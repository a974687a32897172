// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

namespace gaitwright::onnx {

/// An operation on a memory of floats, with the places of its inputs and its output. It allocates nothing.
class Kernel {
 public:
  virtual ~Kernel() = default;
  virtual void Run(float* memory) const = 0;
};

/// A function of one element, with up to two parameters.
using OneFunction = float (*)(float x, float a, float b);

/// out[i] = f(in[i], a, b)
class Elementwise final : public Kernel {
 public:
  struct Places {
    std::int64_t in = 0, out = 0, count = 0;
  };
  Elementwise(OneFunction function, Places places, float a = 0.0F, float b = 0.0F)
      : function_(function), places_(places), a_(a), b_(b) {}
  void Run(float* memory) const override;

 private:
  OneFunction function_;
  Places places_;
  float a_, b_;
};

using TwoFunction = float (*)(float x, float y);

/// out[i] = f(memory[x[i]], memory[y[i]]), with broadcast in the indices.
class Pairwise final : public Kernel {
 public:
  Pairwise(TwoFunction function, std::vector<std::int64_t> x, std::vector<std::int64_t> y, std::int64_t out)
      : function_(function), x_(std::move(x)), y_(std::move(y)), out_(out) {}
  void Run(float* memory) const override;

 private:
  TwoFunction function_;
  std::vector<std::int64_t> x_, y_;
  std::int64_t out_;
};

/// out[i] = memory[from[i]]
class Gathered final : public Kernel {
 public:
  Gathered(std::vector<std::int64_t> from, std::int64_t out) : from_(std::move(from)), out_(out) {}
  void Run(float* memory) const override;

 private:
  std::vector<std::int64_t> from_;
  std::int64_t out_;
};

/// Rows of Y = alpha A B, with A of m x k, B of k x n.
class Product final : public Kernel {
 public:
  struct Places {
    std::int64_t a = 0, b = 0, out = 0;
    std::int64_t m = 0, k = 0, n = 0;
    bool a_transposed = false, b_transposed = false;  ///< stored as k x m, n x k
    float alpha = 1.0F;
  };
  explicit Product(const Places& places) : p_(places) {}
  void Run(float* memory) const override;

 private:
  Places p_;
};

/// y += beta memory[c[i]], for the last term of Gemm.
class Added final : public Kernel {
 public:
  Added(std::vector<std::int64_t> c, std::int64_t out, float beta) : c_(std::move(c)), out_(out), beta_(beta) {}
  void Run(float* memory) const override;

 private:
  std::vector<std::int64_t> c_;
  std::int64_t out_;
  float beta_;
};

}  // namespace gaitwright::onnx
