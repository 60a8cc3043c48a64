package org.evoloop.models.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tools.jackson.databind.JsonNode;

/** The files of the studio's folder, over HTTP. */
class StudioFolderTest extends StudioRequests {
    @Test
    void itListsAndReadsTheFilesOfTheFolder() throws Exception {
        Files.writeString(folder.resolve("fan.yaml"), "converter: fan\n");
        Files.writeString(folder.resolve("notes.md"), "no model\n");
        Files.createDirectories(folder.resolve(".hidden"));
        Files.writeString(folder.resolve(".hidden/x.mmd"), LAMP);
        JsonNode files = ask(200, "GET", "/api/files", "").path("files");
        assertThat(all(files, "path")).containsExactly("fan.yaml", "lamp.md");
        assertThat(files.path(1).path("machines").toString()).isEqualTo("[\"original\",\"new\"]");
        assertThat(ask(200, "GET", "/api/file?path=lamp.md", "").path("text").asString())
                .isEqualTo(LAMP);
    }

    @Test
    void whatIsSavedReplacesOnlyWhatWasRead() throws Exception {
        String version =
                ask(200, "GET", "/api/file?path=lamp.md", "").path("version").asString();
        JsonNode saved = ask(200, "PUT", "/api/file", Map.of("path", "lamp.md", "text", "mine", "version", version));
        assertThat(folder.resolve("lamp.md")).hasContent("mine");
        assertThat(saved.path("version").asString()).isNotEqualTo(version);
        JsonNode conflict =
                ask(409, "PUT", "/api/file", Map.of("path", "lamp.md", "text", "theirs", "version", version));
        assertThat(conflict.path("text").asString()).isEqualTo("mine");
        assertThat(conflict.path("version")).isEqualTo(saved.path("version"));
        assertThat(folder.resolve("lamp.md")).hasContent("mine");
        ask(200, "PUT", "/api/file", Map.of("path", "new/fan.mmd", "text", "x", "version", ""));
        assertThat(folder.resolve("new/fan.mmd")).hasContent("x");
        assertThat(folder.resolve("new").toFile().list()).containsExactly("fan.mmd");
    }

    @Test
    void aReadOnlyFileIsNotReplaced() throws Exception {
        String version =
                ask(200, "GET", "/api/file?path=lamp.md", "").path("version").asString();
        Files.setPosixFilePermissions(folder.resolve("lamp.md"), PosixFilePermissions.fromString("r--r--r--"));
        JsonNode refused = ask(403, "PUT", "/api/file", Map.of("path", "lamp.md", "text", "mine", "version", version));
        assertThat(refused.path("error").asString())
                .isEqualTo("lamp.md is read-only; allow its owner to write it, then save");
        assertThat(folder.resolve("lamp.md")).hasContent(LAMP);
        assertThat(folder.toFile().list()).containsExactly("lamp.md");
        Files.setPosixFilePermissions(folder.resolve("lamp.md"), PosixFilePermissions.fromString("rw-r-----"));
        ask(200, "PUT", "/api/file", Map.of("path", "lamp.md", "text", "mine", "version", version));
        assertThat(Files.getPosixFilePermissions(folder.resolve("lamp.md")))
                .isEqualTo(PosixFilePermissions.fromString("rw-r-----"));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "../lamp.md",
                "/etc/hosts.md",
                "a/../../lamp.md",
                "link.md",
                "away/lamp.md",
                ".hidden.md",
                "passwd",
                "",
                "a\\..\\b.md",
                "a\u0000.md"
            })
    void nothingOutsideOfTheFolderIsReadOrWritten(String path, @TempDir Path outside) throws Exception {
        Files.writeString(outside.resolve("lamp.md"), LAMP);
        Files.createSymbolicLink(folder.resolve("link.md"), outside.resolve("lamp.md"));
        Files.createSymbolicLink(folder.resolve("away"), outside);
        ask(403, "PUT", "/api/file", Map.of("path", path, "text", "x", "version", ""));
        ask(
                403,
                "POST",
                "/api/draw",
                Map.of("pair", Map.of("original", Map.of("path", path), "new", Map.of("path", path))));
        ask(
                403,
                "POST",
                "/api/check",
                Map.of(
                        "pair",
                        Map.of(
                                "original",
                                Map.of("path", "lamp.md"),
                                "new",
                                Map.of("path", "lamp.md"),
                                "texts",
                                Map.of(path, "x"))));
        assertThat(outside.resolve("lamp.md")).hasContent(LAMP);
    }
}
