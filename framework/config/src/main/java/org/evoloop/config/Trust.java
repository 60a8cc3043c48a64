package org.evoloop.config;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyStore;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.security.Security;
import java.security.cert.Certificate;
import java.security.cert.CertificateException;
import java.security.cert.CertificateFactory;
import java.security.cert.X509Certificate;
import java.util.Collection;
import java.util.HexFormat;
import javax.net.ssl.ManagerFactoryParameters;
import javax.net.ssl.SSLEngine;
import javax.net.ssl.TrustManager;
import javax.net.ssl.TrustManagerFactory;
import javax.net.ssl.TrustManagerFactorySpi;
import javax.net.ssl.X509ExtendedTrustManager;
import org.jspecify.annotations.Nullable;

/**
 * Which certificates of a server are trusted: those of a file, or one by its fingerprint.
 *
 * <p>Threading: thread-safe.
 *
 * @since 0.1
 */
public final class Trust {
    /** In place of a fingerprint that nobody has confirmed yet. */
    private static final String ASK = "ask";

    private Trust() {}

    /**
     * Trusts what the certificates in this file, in PEM, have signed.
     *
     * @throws IllegalArgumentException if the file cannot be read, or contains no certificate
     */
    public static TrustManagerFactory in(Path file) {
        Collection<? extends Certificate> certificates;
        try {
            // All bytes first: the file may be a pipe, in which the JDK's stream may fail to find its place.
            certificates = CertificateFactory.getInstance("X.509")
                    .generateCertificates(new ByteArrayInputStream(Files.readAllBytes(file)));
        } catch (IOException unreadable) {
            throw new IllegalArgumentException("the certificates of ca=" + file
                    + " cannot be read; check that the file is there, and that this user may read it");
        } catch (CertificateException malformed) {
            throw noCertificate(file);
        }
        if (certificates.isEmpty()) {
            throw noCertificate(file);
        }
        try {
            KeyStore store = KeyStore.getInstance(KeyStore.getDefaultType());
            store.load(null, null);
            for (Certificate each : certificates) {
                store.setCertificateEntry("ca" + store.size(), each);
            }
            TrustManagerFactory trust = TrustManagerFactory.getInstance(TrustManagerFactory.getDefaultAlgorithm());
            trust.init(store);
            return trust;
        } catch (GeneralSecurityException | IOException impossible) {
            throw new IllegalStateException(impossible);
        }
    }

    private static IllegalArgumentException noCertificate(Path file) {
        return new IllegalArgumentException(
                "ca=" + file + " holds no certificate; it must be in PEM, with -----BEGIN CERTIFICATE-----");
    }

    /**
     * Trusts only the certificate with this fingerprint, whoever signed it and whatever name it is for.
     *
     * @param fingerprint its SHA-256 in hexadecimal digits, with or without colons; {@value #ASK} while nobody has confirmed
     *     one: then none is trusted, and the message says which was shown
     * @throws IllegalArgumentException if it is something else
     */
    public static TrustManagerFactory pinned(String fingerprint) {
        if (fingerprint.equals(ASK)) {
            return new PinnedFactory(new Pinned(new byte[0]));
        }
        String digits = fingerprint.replace(":", "");
        if (!digits.matches("[0-9a-fA-F]{64}")) {
            throw new IllegalArgumentException(
                    "sha256=" + fingerprint + " is no fingerprint, which has 64 digits; this "
                            + "shows it: openssl x509 -in FILE -noout -fingerprint -sha256; or write sha256=" + ASK
                            + ", and the first attempt to connect shows it");
        }
        return new PinnedFactory(new Pinned(HexFormat.of().parseHex(digits)));
    }

    private static final class PinnedFactory extends TrustManagerFactory {
        PinnedFactory(Pinned pinned) {
            super(
                    new TrustManagerFactorySpi() {
                        @Override
                        protected void engineInit(@Nullable KeyStore unused) {
                            // The fingerprint is all that is needed.
                        }

                        @Override
                        protected void engineInit(ManagerFactoryParameters unused) {
                            // As above.
                        }

                        @Override
                        protected TrustManager[] engineGetTrustManagers() {
                            return new TrustManager[] {pinned};
                        }
                    },
                    Security.getProviders()[0],
                    "pinned");
        }
    }

    /** Being an extended one, it also decides about the name of the host. */
    private static final class Pinned extends X509ExtendedTrustManager {
        private final byte[] wanted;

        Pinned(byte[] wanted) {
            this.wanted = wanted;
        }

        private void check(X509Certificate[] chain) throws CertificateException {
            byte[] shown;
            try {
                shown = MessageDigest.getInstance("SHA-256").digest(chain[0].getEncoded());
            } catch (NoSuchAlgorithmException impossible) {
                throw new IllegalStateException(impossible);
            }
            String digits = HexFormat.of().formatHex(shown);
            if (wanted.length == 0) {
                throw new CertificateException("nobody has confirmed it yet, its sha256 is " + digits
                        + "; if it is the device's own, as a second look on another way shows (openssl s_client -connect "
                        + "HOST:PORT </dev/null | openssl x509 -noout -fingerprint -sha256), write sha256=" + digits
                        + " in place of sha256=" + ASK);
            }
            if (!MessageDigest.isEqual(shown, wanted)) {
                throw new CertificateException("it is not the pinned one, its sha256 is " + digits);
            }
        }

        @Override
        public void checkServerTrusted(X509Certificate[] chain, String type) throws CertificateException {
            check(chain);
        }

        @Override
        public void checkServerTrusted(X509Certificate[] chain, String type, Socket socket)
                throws CertificateException {
            check(chain);
        }

        @Override
        public void checkServerTrusted(X509Certificate[] chain, String type, SSLEngine engine)
                throws CertificateException {
            check(chain);
        }

        @Override
        public void checkClientTrusted(X509Certificate[] chain, String type) throws CertificateException {
            check(chain);
        }

        @Override
        public void checkClientTrusted(X509Certificate[] chain, String type, Socket socket)
                throws CertificateException {
            check(chain);
        }

        @Override
        public void checkClientTrusted(X509Certificate[] chain, String type, SSLEngine engine)
                throws CertificateException {
            check(chain);
        }

        @Override
        public X509Certificate[] getAcceptedIssuers() {
            return new X509Certificate[0];
        }
    }
}
