/**
 * The smallest complete event converter, meant to be copied. It gives a lamp that can only be switched on and off a
 * second colour (the paper's running example, section III).
 */
@NullMarked
package org.evoloop.lightbulb;

import org.jspecify.annotations.NullMarked;
