"""The proof of the design: the specification in prism/proof, checked by Spin."""
