/**
 * The live page of a converter: a server on the JDK's HTTP server, and a page without external content.
 *
 * <p>In one direction flows the converter's activity: {@code Broadcast} listens to the converter while there are
 * viewers, a {@code Stream} per viewer sends it to the browser, and {@code page.js} highlights the states in the
 * drawings of {@code org.evoloop.page.drawing}. In the other direction flow commands: {@code Gate} checks access, and
 * {@code Controls} runs them on the console.
 *
 * <p>It uses the console and what that uses.
 */
@NullMarked
package org.evoloop.page;

import org.jspecify.annotations.NullMarked;
