/** Writes SVG pictures: shared by Evoloop's programs. It uses nothing of the framework. */
@NullMarked
package org.evoloop.svg;

import org.jspecify.annotations.NullMarked;
