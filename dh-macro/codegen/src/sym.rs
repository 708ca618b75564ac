//! Expressions: hash-consed graph, tape, evaluator. Knows nothing of mechanics.
