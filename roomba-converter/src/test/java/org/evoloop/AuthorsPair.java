package org.evoloop;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * The cleaning robot as drawn by the paper's authors: their new states have different names from ours, and a time
 * trigger in the model limits the wait for the second press; Astah writes it with encoded brackets.
 */
public final class AuthorsPair {
    private AuthorsPair() {}

    /** Writes a file with the diagrams {@code original} and {@code new}. */
    public static Path write(Path file) throws IOException {
        Path ours = Path.of(System.getProperty("evoloop.root"), "models", "cleaning-robot.xml");
        return Files.writeString(
                file,
                Files.readString(ours)
                        .replace("name=\"Move\"", "name=\"MoveToStartPoint\"")
                        .replace("name=\"timeout\"", "name=\"tm%282s%29\""));
    }
}
