// What a contact remembers of its past, where its law depends on that.
#pragma once

namespace mariotte::contact {

/// The part of its curve that a closed contact follows.
enum class Branch : unsigned char {
  elastic,   ///< never yielded
  plastic,   ///< yielding: deeper than ever before
  unloading  ///< yielded before; elastic about what remains of that, down and up again
};

/// Of one contact. A contact keeps it when it opens.
struct Memory {
  Branch branch = Branch::elastic;
  bool recedes = false;      ///< its bodies part; noted where the law asks for turns
  double peak = 0;           ///< largest indentation to which it has yielded [m]; 0 if it never has
  double adhesion_loss = 0;  ///< lost where it snapped in and let go so far [J]
};

}  // namespace mariotte::contact
