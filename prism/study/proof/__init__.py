"""The design, proved: the specification in prism/proof, checked by Spin."""
