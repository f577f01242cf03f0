// Rows of bits and colour classes for branch_choice_simd.cpp, once for each instruction set.
#if defined(GMCR_COLOR_CLASSES_SIMD_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef GMCR_COLOR_CLASSES_SIMD_HPP
#undef GMCR_COLOR_CLASSES_SIMD_HPP
#else
#define GMCR_COLOR_CLASSES_SIMD_HPP
#endif

#include <hwy/highway.h>

#include "kernels/branch_choice.hpp"

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
  Classes(BranchChoice& choice, RowLoops<kWords> loops)
      : choice_(choice), loops_(loops), work_left_(choice.max_repair_work) {}

  void open() {
    choice_.members[num_classes_] = 0;
    choice_.first_member[num_classes_++] = kNone;
  }

  /// The class opened last.
  Index last() const { return num_classes_ - 1; }
  Index size() const { return num_classes_; }

  HWY_INLINE void add(Index c, Index v) {
    choice_.class_of[v] = static_cast<std::int32_t>(c);
    choice_.next_member[v] = choice_.first_member[c];
    choice_.first_member[c] = static_cast<std::int32_t>(v);
    choice_.members[c] += kOne + static_cast<Tally>(v);
  }

  /// All that is coloured is in classes that no conflict has used up yet.
  void start_repairs() { loops_.subtract(choice_.uncolored, choice_.candidates, choice_.in_use); }

  bool may_repair() const { return choice_.repairs && work_left_ > 0; }
  Index work_left() const { return work_left_; }

  /// Finds a class for v, or a conflict that counts for one.
  bool repair(Index v) { return join(v) || make_room(v) || find_conflict(); }

 private:
  const Word* row(Index v) const { return choice_.rows + v * loops_.num_words(); }

  void copy_members(Tally* to) {
    work_left_ -= num_classes_;
    for (Index c = 0; c < num_classes_; ++c) to[c] = choice_.members[c];
  }

  /// Puts v into a class without neighbours of it.
  bool join(Index v) {
    num_units_ = 0;
    copy_members(choice_.compatible_members);
    loops_.copy(choice_.in_use, choice_.compatible);
    const Index c = remove_incompatible(v, kNone);
    if (c == kNone) {
      list_units();
      return false;
    }
    add(c, v);
    set_bit(choice_.in_use, v);
    return true;
  }

  /// Moves the only neighbour of v in some class to another class.
  bool make_room(Index v) {
    for (Index i = 0; i < num_units_ && i < 2 && work_left_ > 0; ++i) {
      const Index moved = choice_.unit_vertices[i], from = choice_.unit_classes[i];
      const Index to = class_without_neighbors(moved, from);
      if (to == kNone) continue;
      std::int32_t* link = choice_.first_member + from;
      while (*link != moved) link = choice_.next_member + *link;
      *link = choice_.next_member[moved];
      choice_.members[from] -= kOne + static_cast<Tally>(moved);
      add(to, moved);
      add(from, v);
      set_bit(choice_.in_use, v);
      return true;
    }
    return false;
  }

  /// A class other than `own` without neighbours of v.
  Index class_without_neighbors(Index v, Index own) {
    Tally* const left = choice_.other_members;
    copy_members(left);
    left[own] = kUsedUp;
    work_left_ -= loops_.num_words();
    const Word* const neighbors = row(v);
    for (Index w = 0; w < loops_.num_words(); ++w) {
      for (Word rest = choice_.in_use[w] & ~neighbors[w]; rest != 0; rest &= rest - 1) {
        --work_left_;
        const Index member = 64 * w + __builtin_ctzll(rest);
        const Index c = choice_.class_of[member];
        if ((left[c] -= kOne + static_cast<Tally>(member)) == 0) return c;
      }
    }
    return kNone;
  }

  /// Unit propagation: a clique with v and a member of every class would have each unit vertex.
  bool find_conflict() {
    for (Index i = 0; i < num_units_ && work_left_ > 0; ++i) {
      const Index unit = choice_.unit_vertices[i];
      clear_bit(choice_.compatible, unit);
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
    const Word* const neighbors = row(v);
    work_left_ -= loops_.num_words();
    for (Index w = 0; w < loops_.num_words(); ++w) {
      Word rest = choice_.compatible[w] & ~neighbors[w];
      choice_.compatible[w] &= neighbors[w];
      for (; rest != 0; rest &= rest - 1) {
        const Index member = 64 * w + __builtin_ctzll(rest);
        const std::int32_t c = choice_.class_of[member];
        --work_left_;
        choice_.removed_by[member] = static_cast<std::int32_t>(i);
        const Tally left = choice_.compatible_members[c] -= kOne + static_cast<Tally>(member);
        if (left == 0) return c;
        choice_.unit_classes[num_units_] = c;
        num_units_ += left < 2 * kOne;
      }
    }
    return kNone;
  }

  /// Lists the classes with one compatible member.
  void list_units() {
    num_units_ = 0;
    for (Index c = 0; c < num_classes_; ++c) {
      choice_.unit_classes[num_units_] = static_cast<std::int32_t>(c);
      num_units_ += choice_.compatible_members[c] < 2 * kOne;
    }
    for (Index i = 0; i < num_units_; ++i) name_unit(i);
  }

  /// Sets the vertex of unit i, whose class is known.
  HWY_INLINE void name_unit(Index i) {
    const Tally left = choice_.compatible_members[choice_.unit_classes[i]];
    const auto member = static_cast<std::int32_t>(left - kOne);
    choice_.removed_by[member] = kNone;
    choice_.unit_vertices[i] = member;
  }

  /// Takes out of use the classes that a conflict in class `conflict` rests on: those whose units
  /// removed the members of such a class.
  void use_up(Index conflict) {
    Index num_involved = 0;
    const auto involve = [&](Index c) {
      if (choice_.members[c] == kUsedUp) return;
      choice_.members[c] = kUsedUp;
      choice_.involved[num_involved++] = static_cast<std::int32_t>(c);
    };
    involve(conflict);
    for (Index next = 0; next < num_involved; ++next) {
      const Index c = choice_.involved[next];
      for (Index v = choice_.first_member[c]; v != kNone; v = choice_.next_member[v]) {
        --work_left_;
        clear_bit(choice_.in_use, v);
        if (choice_.removed_by[v] != kNone) involve(choice_.unit_classes[choice_.removed_by[v]]);
      }
    }
  }

  BranchChoice& choice_;
  RowLoops<kWords> loops_;
  Index work_left_;
  Index num_classes_ = 0, num_units_ = 0;
};

}  // namespace gmcr::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
