"""The study of performance and robustness: the paper's Exp. 2, and what comes after it."""
