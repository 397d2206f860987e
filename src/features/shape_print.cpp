// SPDX-License-Identifier: GPL-3.0-or-later
#include "features/shape_print.h"

#include <BinTools_ShapeSet.hxx>
#include <TopoDS_Shape.hxx>
#include <cstring>
#include <ostream>
#include <streambuf>

namespace featuremesh {

namespace {

/// Adds up what is written to it.
class PrintBuffer : public std::streambuf {
  public:
    std::uint64_t print() const { return sum_; }

  protected:
    int_type overflow(int_type c) override {
        add(static_cast<std::uint64_t>(c));
        ++position_;
        return c;
    }
    std::streamsize xsputn(const char* bytes, std::streamsize count) override {
        std::streamsize i = 0;
        for (; i + 8 <= count; i += 8) {
            std::uint64_t word;
            std::memcpy(&word, bytes + i, 8);
            add(word);
        }
        for (; i < count; ++i) add(static_cast<unsigned char>(bytes[i]));
        position_ += count;
        return count;
    }
    pos_type seekoff(off_type, std::ios_base::seekdir, std::ios_base::openmode) override { return position_; }

  private:
    void add(std::uint64_t word) {
        sum_ = (sum_ ^ word) * 0xbf58476d1ce4e5b9ull;
        sum_ ^= sum_ >> 29;
    }
    std::uint64_t sum_ = 0x9e3779b97f4a7c15ull;
    std::streamoff position_ = 0;
};

}  // namespace

std::uint64_t print_of(const TopoDS_Shape& shape) {
    PrintBuffer buffer;
    std::ostream out(&buffer);
    BinTools_ShapeSet set;
    set.SetWithTriangles(false);
    set.Add(shape);
    set.Write(out);
    set.Write(shape, out);
    return buffer.print();
}

}  // namespace featuremesh
