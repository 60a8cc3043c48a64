/** Shared by Evoloop's own programs: error messages, options and SVG. It uses nothing of the framework. */
@NullMarked
package org.evoloop.program;

import org.jspecify.annotations.NullMarked;
