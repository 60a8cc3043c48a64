/**
 * Makes a static site of the project's Markdown. It may use nothing else of Evoloop.
 */
@NullMarked
package org.evoloop.site;

import org.jspecify.annotations.NullMarked;
