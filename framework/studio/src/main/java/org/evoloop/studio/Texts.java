package org.evoloop.studio;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Map;
import org.evoloop.payload.JsonRecord;
import org.evoloop.xmi.ModelFile;

/**
 * The texts of a request: those that it brings, and those on disk.
 *
 * <p>Threading: for the thread of the request.
 */
final class Texts {
    private final Folder folder;
    private final Map<String, String> brought = new HashMap<>();
    private final Map<String, ModelFile> read = new HashMap<>();

    /** @param request has the member {@code texts} if it brings some */
    Texts(Folder folder, JsonRecord request) {
        this.folder = folder;
        request.inner("texts")
                .ifPresent(texts -> texts.names().forEach(path -> {
                    folder.require(path);
                    brought.put(path, texts.text(path));
                }));
    }

    /** The texts that the request brings, by their paths. */
    Map<String, String> brought() {
        return brought;
    }

    /** The text of {@code path}, as it was brought or as it is on disk. */
    String text(String path) {
        String text = brought.get(path);
        return text == null ? folder.read(path).text() : text;
    }

    /** The machine that {@code reference}, with a path and perhaps a name, is about. */
    Source source(JsonRecord reference) {
        String path = reference.text("path");
        folder.require(path);
        return new Source(path, reference.text("name", ""), () -> file(path));
    }

    private ModelFile file(String path) {
        ModelFile known = read.get(path);
        if (known == null) {
            String text = brought.get(path);
            known = text == null
                    ? folder.models(path)
                    : ModelFile.read(path, new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)));
            read.put(path, known);
        }
        return known;
    }
}
