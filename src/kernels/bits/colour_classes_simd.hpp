// Rows of bits and colour classes for branch_choice_simd.cpp, once for each instruction set.
#if defined(GMCR_COLOUR_CLASSES_SIMD_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GMCR_COLOUR_CLASSES_SIMD_HPP
#undef GMCR_COLOUR_CLASSES_SIMD_HPP
#else
#define GMCR_COLOUR_CLASSES_SIMD_HPP
#endif

#include <hwy/highway.h>

#include "kernels/bits/branch_choice.hpp"

HWY_BEFORE_NAMESPACE();
namespace gmcr::kernels::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Word = std::uint64_t;

constexpr Index kNone = -1;

/// The number of some vertices (high half) and the sum of their indices: once it is down to one, it
/// says which one is left.
using Tally = std::uint64_t;
constexpr Tally kOne = Tally{1} << 32;
constexpr Tally kUsedUp = Tally{1} << 62;  // of a class that is out of use: never runs out

HWY_INLINE bool has_bit(const Word* row, Index v) { return (row[v / 64] >> (v % 64)) & 1u; }
HWY_INLINE void set_bit(Word* row, Index v) { row[v / 64] |= Word{1} << (v % 64); }
HWY_INLINE void clear_bit(Word* row, Index v) { row[v / 64] &= ~(Word{1} << (v % 64)); }

/// Rows of kWords words, or of a multiple of 8 that is known at run time for kWords = 0.
template <int kWords>
struct RowLoops {
  using Words = hn::CappedTag<Word, kWords == 4 ? 4 : 8>;
  using Vector = hn::Vec<Words>;

  Index num_words_at_run_time = 0;

  HWY_INLINE Index num_words() const { return kWords != 0 ? kWords : num_words_at_run_time; }
  static HWY_INLINE Index step() { return static_cast<Index>(hn::Lanes(Words())); }
  static HWY_INLINE Vector load(const Word* row, Index i) { return hn::Load(Words(), row + i); }

  HWY_INLINE void copy(const Word* from, Word* to) const {
    for (Index i = 0; i < num_words(); i += step()) {
      hn::Store(load(from, i), Words(), to + i);
    }
  }

  /// to = from without the bits of `row`.
  HWY_INLINE void subtract(const Word* row, const Word* from, Word* to,
                           Index first_word = 0) const {
    const Index first = kWords != 0 ? 0 : first_word / step() * step();
    for (Index i = first; i < num_words(); i += step()) {
      hn::Store(hn::AndNot(load(row, i), load(from, i)), Words(), to + i);
    }
  }

  HWY_INLINE Index count_intersection(const Word* a, const Word* b, Word* both) const {
    const Words words;
    auto counts = hn::Zero(words);
    for (Index i = 0; i < num_words(); i += step()) {
      const Vector common = hn::And(load(a, i), load(b, i));
      hn::Store(common, words, both + i);
      counts = hn::Add(counts, hn::PopulationCount(common));
    }
    return static_cast<Index>(hn::GetLane(hn::SumOfLanes(words, counts)));
  }
};

/// Colour classes as linked lists of their members, and what can be done for vertices without one.
template <int kWords>
class Classes {
 public:
  Classes(const BranchInput& input, BranchScratch& scratch, RowLoops<kWords> loops)
      : input_(input),
        lists_(scratch),
        in_use_(scratch.in_use.data()),
        compatible_(scratch.compatible.data()),
        loops_(loops),
        work_left_(input.max_repair_work) {}

  void open() {
    lists_.members[num_classes_] = 0;
    lists_.first_member[num_classes_++] = kNone;
  }

  /// The class opened last.
  Index last() const { return num_classes_ - 1; }
  Index size() const { return num_classes_; }

  HWY_INLINE void add(Index c, Index v) {
    lists_.class_of[v] = static_cast<std::int32_t>(c);
    lists_.next_member[v] = lists_.first_member[c];
    lists_.first_member[c] = static_cast<std::int32_t>(v);
    lists_.members[c] += kOne + static_cast<Tally>(v);
  }

  /// All that is coloured is in classes that no conflict has used up yet.
  void start_repairs() { loops_.subtract(lists_.uncoloured.data(), input_.candidates, in_use_); }

  bool may_repair() const { return input_.repairs && work_left_ > 0; }
  Index work_left() const { return work_left_; }

  /// Finds a class for v, or a conflict that counts for one.
  bool repair(Index v) { return join(v) || make_room(v) || find_conflict(); }

 private:
  const Word* row(Index v) const { return input_.rows + v * loops_.num_words(); }

  void copy_members(Tally* to) {
    work_left_ -= num_classes_;
    for (Index c = 0; c < num_classes_; ++c) to[c] = lists_.members[c];
  }

  /// Puts v into a class without neighbours of it.
  bool join(Index v) {
    num_units_ = 0;
    copy_members(lists_.compatible_members.data());
    loops_.copy(in_use_, compatible_);
    const Index c = remove_incompatible(v, kNone);
    if (c == kNone) {
      list_units();
      return false;
    }
    add(c, v);
    set_bit(in_use_, v);
    return true;
  }

  /// Moves the only neighbour of v in some class to another class.
  bool make_room(Index v) {
    for (Index i = 0; i < num_units_ && i < 2 && work_left_ > 0; ++i) {
      const Index moved = lists_.unit_vertices[i], from = lists_.unit_classes[i];
      const Index to = class_without_neighbours(moved, from);
      if (to == kNone) continue;
      std::int32_t* link = lists_.first_member.data() + from;
      while (*link != moved) link = lists_.next_member.data() + *link;
      *link = lists_.next_member[moved];
      lists_.members[from] -= kOne + static_cast<Tally>(moved);
      add(to, moved);
      add(from, v);
      set_bit(in_use_, v);
      return true;
    }
    return false;
  }

  /// A class other than `own` without neighbours of v.
  Index class_without_neighbours(Index v, Index own) {
    Tally* const left = lists_.other_members.data();
    copy_members(left);
    left[own] = kUsedUp;
    work_left_ -= loops_.num_words();
    const Word* const neighbours = row(v);
    for (Index w = 0; w < loops_.num_words(); ++w) {
      for (Word rest = in_use_[w] & ~neighbours[w]; rest != 0; rest &= rest - 1) {
        --work_left_;
        const Index member = 64 * w + __builtin_ctzll(rest);
        const Index c = lists_.class_of[member];
        if ((left[c] -= kOne + static_cast<Tally>(member)) == 0) return c;
      }
    }
    return kNone;
  }

  /// Unit propagation: a clique with v and a member of every class would have each unit vertex.
  bool find_conflict() {
    for (Index i = 0; i < num_units_ && work_left_ > 0; ++i) {
      const Index unit = lists_.unit_vertices[i];
      clear_bit(compatible_, unit);
      const Index first_new = num_units_;
      const Index conflict = remove_incompatible(unit, i);
      if (conflict != kNone) {
        use_up(conflict);
        return true;
      }
      for (Index k = first_new; k < num_units_; ++k) name_unit(k);
    }
    return false;
  }

  /// Removes from `compatible` what is not adjacent to v, the vertex of unit i. The classes with
  /// one compatible member become units, whose vertices are not known yet.
  /// @return a class that is left without compatible members; kNone where there is none.
  HWY_INLINE Index remove_incompatible(Index v, Index i) {
    const Word* const neighbours = row(v);
    work_left_ -= loops_.num_words();
    for (Index w = 0; w < loops_.num_words(); ++w) {
      Word rest = compatible_[w] & ~neighbours[w];
      compatible_[w] &= neighbours[w];
      for (; rest != 0; rest &= rest - 1) {
        const Index member = 64 * w + __builtin_ctzll(rest);
        const std::int32_t c = lists_.class_of[member];
        --work_left_;
        lists_.removed_by[member] = static_cast<std::int32_t>(i);
        const Tally left = lists_.compatible_members[c] -= kOne + static_cast<Tally>(member);
        if (left == 0) return c;
        lists_.unit_classes[num_units_] = c;
        num_units_ += left < 2 * kOne;
      }
    }
    return kNone;
  }

  /// Lists the classes with one compatible member.
  void list_units() {
    num_units_ = 0;
    for (Index c = 0; c < num_classes_; ++c) {
      lists_.unit_classes[num_units_] = static_cast<std::int32_t>(c);
      num_units_ += lists_.compatible_members[c] < 2 * kOne;
    }
    for (Index i = 0; i < num_units_; ++i) name_unit(i);
  }

  /// Sets the vertex of unit i, whose class is known.
  HWY_INLINE void name_unit(Index i) {
    const Tally left = lists_.compatible_members[lists_.unit_classes[i]];
    const auto member = static_cast<std::int32_t>(left - kOne);
    lists_.removed_by[member] = kNone;
    lists_.unit_vertices[i] = member;
  }

  /// Takes out of use the classes that a conflict in class `conflict` rests on: those whose units
  /// removed the members of such a class.
  void use_up(Index conflict) {
    Index num_involved = 0;
    const auto involve = [&](Index c) {
      if (lists_.members[c] == kUsedUp) return;
      lists_.members[c] = kUsedUp;
      lists_.involved[num_involved++] = static_cast<std::int32_t>(c);
    };
    involve(conflict);
    for (Index next = 0; next < num_involved; ++next) {
      const Index c = lists_.involved[next];
      for (Index v = lists_.first_member[c]; v != kNone; v = lists_.next_member[v]) {
        --work_left_;
        clear_bit(in_use_, v);
        if (lists_.removed_by[v] != kNone) involve(lists_.unit_classes[lists_.removed_by[v]]);
      }
    }
  }

  const BranchInput& input_;
  BranchScratch& lists_;
  Word *in_use_, *compatible_;
  RowLoops<kWords> loops_;
  Index work_left_;
  Index num_classes_ = 0, num_units_ = 0;
};

}  // namespace gmcr::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
