"""The study of performance and robustness: the paper's Exp. 2, and our extensions."""
