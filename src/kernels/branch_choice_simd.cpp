// Compiled once for each instruction set; the machine picks one at run time.
#define HWY_WANT_AVX3_DL 1  // hardware popcounts of whole vectors
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/branch_choice_simd.cpp"
#include <hwy/foreach_target.h>
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

template <int kWords>
class Chooser {
 public:
  Chooser(BranchChoice& choice, RowLoops<kWords> loops)
      : choice_(choice), loops_(loops), classes_(choice, loops) {}

  void run() {
    loops_.copy(choice_.candidates, choice_.uncolored);
    color();
    classes_.start_repairs();
    append_rest();
  }

 private:
  const Word* row(Index v) const { return choice_.rows + v * loops_.num_words(); }

  /// Whether to go on, after that many word operations.
  bool spend(Index work) {
    unreported_work_ += work;
    if (unreported_work_ < kWorkPerReport) return true;
    ended_ = ended_ || !choice_.spend(choice_.budget, unreported_work_);
    unreported_work_ = 0;
    return !ended_;
  }

  void color() {
    Word* const uncolored = choice_.uncolored;
    Word* const free = choice_.free;
    Index first_word = 0;
    while (classes_.size() < choice_.max_classes && !ended_) {
      while (first_word < loops_.num_words() && uncolored[first_word] == 0) ++first_word;
      if (first_word == loops_.num_words()) return;
      classes_.open();
      loops_.copy(uncolored, free);
      const Index num_before = num_colored_;
      if (classes_.last() < choice_.num_seeds) take_seed(choice_.seeds[classes_.last()]);
      for (Index w = first_word; w < loops_.num_words(); ++w) {
        Word rest = free[w], taken = 0;
        while (rest != 0) {
          const Index v = 64 * w + __builtin_ctzll(rest);
          const Word lowest = rest & -rest;
          taken |= lowest;
          rest &= ~(row(v)[w] | lowest);
          loops_.subtract(row(v), free, free, w);
          if (choice_.repairs) classes_.add(classes_.last(), v);
          ++num_colored_;
        }
        uncolored[w] &= ~taken;
      }
      spend((num_colored_ - num_before) * loops_.num_words());
    }
  }

  void take_seed(Index v) {
    if (!has_bit(choice_.free, v)) return;
    loops_.subtract(row(v), choice_.free, choice_.free);
    clear_bit(choice_.free, v);
    clear_bit(choice_.uncolored, v);
    if (choice_.repairs) classes_.add(classes_.last(), v);
    ++num_colored_;
  }

  /// One independent set after the other of what has no class.
  void append_rest() {
    choice_.num_branches = 0;
    choice_.is_clique = num_colored_ == classes_.size();
    Index bound = choice_.max_classes;
    for (Index first_word = 0; first_word < loops_.num_words();) {
      if (choice_.uncolored[first_word] == 0) {
        ++first_word;
      } else {
        loops_.copy(choice_.uncolored, choice_.free);
        bound = append_class(first_word, bound);
      }
    }
  }

  Index append_class(Index first_word, Index bound) {
    Index class_size = 0, num_taken = 0;
    for (Index w = first_word; w < loops_.num_words(); ++w) {
      while (choice_.free[w] != 0) {
        const Index v = 64 * w + __builtin_ctzll(choice_.free[w]);
        clear_bit(choice_.free, v);
        clear_bit(choice_.uncolored, v);
        ++num_taken;
        if (!ended_ && repair(v)) continue;
        if (!ended_) loops_.subtract(row(v), choice_.free, choice_.free, w);
        if (class_size++ == 0 || ended_) ++bound;
        append(v, bound);
      }
    }
    choice_.is_clique = choice_.is_clique && num_taken == 1 && class_size == 1;
    return bound;
  }

  bool repair(Index v) {
    if (!classes_.may_repair()) return spend(loops_.num_words()), false;
    const Index work_before = classes_.work_left();
    const bool repaired = classes_.repair(v);
    spend(work_before - classes_.work_left());
    return repaired;
  }

  void append(Index v, Index bound) {
    choice_.branch_vertices[choice_.num_branches] = static_cast<std::int32_t>(v);
    choice_.branch_bounds[choice_.num_branches++] = static_cast<std::int32_t>(bound);
  }

  static constexpr Index kWorkPerReport = Index{1} << 16;

  BranchChoice& choice_;
  RowLoops<kWords> loops_;
  Classes<kWords> classes_;
  Index num_colored_ = 0;
  Index unreported_work_ = 0;
  bool ended_ = false;
};

void choose_branches(BranchChoice& choice) {
  switch (choice.num_words) {
    case 4:
      return Chooser<4>(choice, {}).run();
    case 8:
      return Chooser<8>(choice, {}).run();
    case 16:
      return Chooser<16>(choice, {}).run();
    default:
      return Chooser<0>(choice, {choice.num_words}).run();
  }
}

Index intersect(const Word* here, const Word* neighbors, Index num_words, Word* next) {
  if (num_words == 4) return RowLoops<4>{}.count_intersection(here, neighbors, next);
  return RowLoops<0>{num_words}.count_intersection(here, neighbors, next);
}

}  // namespace gmcr::kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gmcr::kernels {

HWY_EXPORT(choose_branches);
HWY_EXPORT(intersect);

void choose_branches(BranchChoice& choice) { HWY_DYNAMIC_DISPATCH(choose_branches)(choice); }

Index intersect(const std::uint64_t* here, const std::uint64_t* neighbors, Index num_words,
                std::uint64_t* next) {
  return HWY_DYNAMIC_DISPATCH(intersect)(here, neighbors, num_words, next);
}

}  // namespace gmcr::kernels
#endif
