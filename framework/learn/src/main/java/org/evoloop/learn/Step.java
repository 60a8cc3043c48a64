package org.evoloop.learn;

/** An input, and what was heard after it. */
record Step(String input, Heard heard) {}
