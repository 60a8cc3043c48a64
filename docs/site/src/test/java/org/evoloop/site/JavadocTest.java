package org.evoloop.site;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.source.tree.ClassTree;
import com.sun.source.tree.CompilationUnitTree;
import com.sun.source.tree.ExportsTree;
import com.sun.source.tree.MethodTree;
import com.sun.source.tree.ModifiersTree;
import com.sun.source.tree.Tree;
import com.sun.source.tree.VariableTree;
import com.sun.source.util.DocTrees;
import com.sun.source.util.JavacTask;
import com.sun.source.util.TreePath;
import com.sun.source.util.TreePathScanner;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import javax.lang.model.element.Modifier;
import javax.tools.JavaCompiler;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Everything that a module exports has a comment, and its types have {@code @since}. */
class JavadocTest {
    private static final Path ROOT = Path.of(System.getProperty("evoloop.root"));

    @TempDir
    private Path directory;

    @Test
    void allOfTheApiIsExplained() throws IOException {
        List<Path> modules = libraries();

        assertThat(modules).hasSizeGreaterThan(10);
        assertThat(modules.stream().flatMap(module -> missing(module).stream())).isEmpty();
    }

    @Test
    void whatIsMissingIsFound() throws IOException {
        Files.writeString(directory.resolve("module-info.java"), "module a { exports a.b; }");
        Path folder = Files.createDirectories(directory.resolve("a/b"));
        Files.writeString(folder.resolve("A.java"), """
                package a.b;
                /** Explained. */
                public class A {
                    public int field;
                    /** Explained. */
                    protected void method() {}
                    protected void silent() {}
                    void internal() {}
                    @Override public String toString() { return ""; }
                    /** Explained. */
                    public record R(int a) { public R { } }
                    public enum E { X }
                    private static class P { public void no() {} }
                }
                """);
        Files.writeString(
                folder.resolve("I.java"),
                "package a.b;\n/** An interface. @since 1 */\npublic interface I { void m(); }");

        assertThat(missing(directory))
                .containsExactlyInAnyOrder(
                        "A.java:3: A has no @since",
                        "A.java:4: field has no comment",
                        "A.java:7: silent has no comment",
                        "A.java:12: E has no comment",
                        "A.java:12: X has no comment",
                        "I.java:3: m has no comment");
    }

    /** The modules that are published as libraries; an application exports nothing. */
    private static List<Path> libraries() throws IOException {
        try (Stream<Path> files =
                Files.find(ROOT, 6, (file, attributes) -> file.endsWith("src/main/java/module-info.java"))) {
            return files.map(Path::getParent)
                    .filter(folder -> !folder.toString().contains("opencv-debian"))
                    .sorted()
                    .toList();
        }
    }

    private static List<String> missing(Path module) {
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        List<String> found = new ArrayList<>();
        try (StandardJavaFileManager files = compiler.getStandardFileManager(null, Locale.ROOT, null)) {
            for (Path folder : exported(compiler, files, module)) {
                try (Stream<Path> sources = Files.list(folder)) {
                    List<Path> types = sources.filter(
                                    file -> file.toString().endsWith(".java") && !file.endsWith("package-info.java"))
                            .toList();
                    JavacTask task = task(compiler, files, types);
                    DocTrees comments = DocTrees.instance(task);
                    for (CompilationUnitTree unit : task.parse()) {
                        new Members(comments, found).scan(unit, null);
                    }
                }
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return found;
    }

    private static JavacTask task(JavaCompiler compiler, StandardJavaFileManager files, List<Path> sources) {
        return (JavacTask) compiler.getTask(null, files, null, null, null, files.getJavaFileObjectsFromPaths(sources));
    }

    /** Packages exported to everyone; those exported to one module only are not API. */
    private static List<Path> exported(JavaCompiler compiler, StandardJavaFileManager files, Path module)
            throws IOException {
        List<Path> folders = new ArrayList<>();
        for (CompilationUnitTree unit : task(compiler, files, List.of(module.resolve("module-info.java")))
                .parse()) {
            unit.getModule().getDirectives().forEach(directive -> {
                if (directive instanceof ExportsTree exports && exports.getModuleNames() == null) {
                    folders.add(
                            module.resolve(exports.getPackageName().toString().replace('.', '/')));
                }
            });
        }
        return folders;
    }

    /** Visits members that are public or protected, as are all their enclosing types. */
    private static final class Members extends TreePathScanner<Void, Void> {
        private final DocTrees comments;
        private final List<String> found;

        Members(DocTrees comments, List<String> found) {
            this.comments = comments;
            this.found = found;
        }

        @Override
        public Void visitClass(ClassTree type, Void unused) {
            if (!isApi(type.getModifiers())) {
                return null;
            }
            requireComment(type.getSimpleName());
            if (getCurrentPath().getParentPath().getLeaf() instanceof CompilationUnitTree
                    && !comment().contains("@since")) {
                report(type.getSimpleName() + " has no @since");
            }
            return super.visitClass(type, unused);
        }

        @Override
        public Void visitMethod(MethodTree method, Void unused) {
            boolean overrides = method.getModifiers().getAnnotations().stream()
                    .anyMatch(annotation ->
                            annotation.getAnnotationType().toString().equals("Override"));
            if (isApi(method.getModifiers()) && !overrides && !isCompactConstructor(method)) {
                requireComment(method.getName().contentEquals("<init>") ? "constructor" : method.getName());
            }
            return null;
        }

        @Override
        public Void visitVariable(VariableTree field, Void unused) {
            boolean component = owner().getKind() == Tree.Kind.RECORD
                    && !field.getModifiers().getFlags().contains(Modifier.STATIC);
            if (isApi(field.getModifiers()) && !component) {
                requireComment(field.getName());
            }
            return null;
        }

        /** The record's own comment explains its components and the values that it refuses. */
        private boolean isCompactConstructor(MethodTree method) {
            if (owner().getKind() != Tree.Kind.RECORD || !method.getName().contentEquals("<init>")) {
                return false;
            }
            CompilationUnitTree unit = getCurrentPath().getCompilationUnit();
            long start = comments.getSourcePositions().getStartPosition(unit, method);
            try {
                String text =
                        unit.getSourceFile().getCharContent(true).toString().substring((int) start);
                return text.indexOf('{') < text.indexOf('(') || !text.contains("(");
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
        }

        private Tree owner() {
            return getCurrentPath().getParentPath().getLeaf();
        }

        private boolean isApi(ModifiersTree modifiers) {
            TreePath parent = getCurrentPath().getParentPath();
            boolean inInterface = parent.getLeaf().getKind() == Tree.Kind.INTERFACE;
            return (inInterface && !modifiers.getFlags().contains(Modifier.PRIVATE))
                    || modifiers.getFlags().contains(Modifier.PUBLIC)
                    || modifiers.getFlags().contains(Modifier.PROTECTED);
        }

        private String comment() {
            String comment = comments.getDocComment(getCurrentPath());
            return comment == null ? "" : comment;
        }

        private void requireComment(CharSequence name) {
            if (comment().isBlank()) {
                report(name + " has no comment");
            }
        }

        private void report(String problem) {
            CompilationUnitTree unit = getCurrentPath().getCompilationUnit();
            long start = comments.getSourcePositions()
                    .getStartPosition(unit, getCurrentPath().getLeaf());
            found.add(Path.of(unit.getSourceFile().getName()).getFileName() + ":"
                    + unit.getLineMap().getLineNumber(start) + ": " + problem);
        }
    }
}
