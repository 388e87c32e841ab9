int main() {}  // only for what is precompiled with it
